using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>_NET_WM_ICON: width, height, then the pixels as 0xAARRGGBB, not premultiplied, one to each long.</summary>
internal static class NetWmIcon
{
    public static nint[] Pack(IconPicture picture)
    {
        var packed = new nint[2 + picture.Pixels.Length];
        packed[0] = picture.Size.Width;
        packed[1] = picture.Size.Height;
        for (var i = 0; i < picture.Pixels.Length; i++) packed[2 + i] = (nint)Straight(picture.Pixels[i]);
        return packed;
    }

    private static uint Straight(uint premultiplied)
    {
        var alpha = premultiplied >> 24;
        if (alpha is 0 or 255) return premultiplied;
        return (alpha << 24) | (Channel(premultiplied >> 16, alpha) << 16) | (Channel(premultiplied >> 8, alpha) << 8) | Channel(premultiplied, alpha);
    }

    private static uint Channel(uint value, uint alpha) => Math.Min(255, ((value & 0xFF) * 255 + alpha / 2) / alpha);
}
