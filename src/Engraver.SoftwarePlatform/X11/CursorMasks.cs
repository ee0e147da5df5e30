using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A picture as a pair of X bitmaps: where it is light, and where it is opaque. Rows are padded to bytes, the lowest bit is the leftmost
/// pixel.</summary>
internal static class CursorMasks
{
    public static (byte[] Light, byte[] Mask) Create(IconPicture picture)
    {
        var stride = (picture.Size.Width + 7) / 8;
        var light = new byte[stride * picture.Size.Height];
        var mask = new byte[light.Length];
        for (var i = 0; i < picture.Pixels.Length; i++)
        {
            var pixel = picture.Pixels[i];
            var (x, y) = (i % picture.Size.Width, i / picture.Size.Width);
            if (pixel >> 24 < 128) continue;
            mask[y * stride + x / 8] |= (byte)(1 << (x % 8));
            if (IsLight(pixel)) light[y * stride + x / 8] |= (byte)(1 << (x % 8));
        }

        return (light, mask);
    }

    /// <summary>True for a luminance above half (ITU-R BT.601).</summary>
    private static bool IsLight(uint pixel) => ((pixel >> 16) & 0xFF) * 299 + ((pixel >> 8) & 0xFF) * 587 + (pixel & 0xFF) * 114 >= 127_500;
}
