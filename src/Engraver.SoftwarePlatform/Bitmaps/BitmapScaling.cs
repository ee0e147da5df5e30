using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Makes copies of another size. The copies are premultiplied with blue first.</summary>
internal static class BitmapScaling
{
    public static SoftwareBitmap Resized(SoftwareBitmap source, PixelSize size, bool isSmooth)
    {
        var isSmaller = size.Width <= source.PixelSize.Width && size.Height <= source.PixelSize.Height;
        return isSmooth && isSmaller ? Averaged(source, size) : Sampled(source, size, isSmooth);
    }

    /// <summary>Each pixel is the mean of the area that it covers; meant for smaller sizes.</summary>
    public static SoftwareBitmap Averaged(SoftwareBitmap source, PixelSize size)
    {
        var columns = AreaWeights.Along(source.PixelSize.Width, size.Width);
        var rows = AreaWeights.Along(source.PixelSize.Height, size.Height);
        var result = new SoftwareBitmap(size, source.Dpi);
        for (var y = 0; y < result.PixelSize.Height; y++)
        {
            var target = result.Row(y);
            for (var x = 0; x < target.Length; x++)
                target[x] = Mean(source, columns[x], rows[y]);
        }
        return result;
    }

    private static SoftwareBitmap Sampled(SoftwareBitmap source, PixelSize size, bool isSmooth)
    {
        var result = new SoftwareBitmap(size, source.Dpi);
        var readable = source.ForReading(0);
        var toImage = Matrix.CreateScale((double)source.PixelSize.Width / result.PixelSize.Width, (double)source.PixelSize.Height / result.PixelSize.Height);
        var paint = new ImagePaint(readable.Source, toImage, readable.Bounds, ImageWrap.Clamp, ImageWrap.Clamp, isSmooth, 255);
        for (var y = 0; y < result.PixelSize.Height; y++)
            paint.Shade(0, y, result.Row(y));
        return result;
    }

    private static uint Mean(SoftwareBitmap source, AreaWeights columns, AreaWeights rows)
    {
        float blue = 0, green = 0, red = 0, alpha = 0;
        for (var y = rows.First; y <= rows.Last; y++)
        {
            var pixels = source.Row(y);
            var weightY = rows[y];
            for (var x = columns.First; x <= columns.Last; x++)
            {
                var pixel = source.Converted(pixels[x]);
                var weight = weightY * columns[x];
                blue += weight * (pixel & 255);
                green += weight * ((pixel >> 8) & 255);
                red += weight * ((pixel >> 16) & 255);
                alpha += weight * (pixel >> 24);
            }
        }
        return Rounded(alpha) << 24 | Rounded(red) << 16 | Rounded(green) << 8 | Rounded(blue);
    }

    private static uint Rounded(float value) => (uint)(value + 0.5f);
}
