using Avalonia;
using Avalonia.Media.Imaging;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A small picture: one number per pixel, 0xAARRGGBB, premultiplied, rows from the top.</summary>
internal sealed record IconPicture(PixelSize Size, uint[] Pixels)
{
    public static unsafe IconPicture From(Bitmap bitmap)
    {
        var size = bitmap.PixelSize;
        var pixels = new uint[size.Width * size.Height];
        fixed (uint* start = pixels) bitmap.CopyPixels(new PixelRect(size), (nint)start, pixels.Length * 4, size.Width * 4);
        if (bitmap.Format == Avalonia.Platform.PixelFormat.Rgba8888) SwapRedAndBlue(pixels);
        return new IconPicture(size, pixels);
    }

    private static void SwapRedAndBlue(uint[] pixels)
    {
        for (var i = 0; i < pixels.Length; i++)
        {
            var pixel = pixels[i];
            pixels[i] = (pixel & 0xFF00FF00) | ((pixel & 0xFF) << 16) | ((pixel >> 16) & 0xFF);
        }
    }
}
