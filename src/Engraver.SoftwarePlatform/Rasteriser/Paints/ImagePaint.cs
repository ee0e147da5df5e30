using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Takes pixels from part of an image, the nearest or a mix of four.</summary>
/// <param name="source">Its owner keeps it alive while this paint is used.</param>
/// <param name="toImage">From device pixels to image pixels.</param>
/// <param name="domain">The part of the image that is used; <paramref name="wrapX"/> and <paramref name="wrapY"/> say what is outside it.</param>
/// <param name="opacity">0 to 255.</param>
internal sealed class ImagePaint(PixelSource source, Matrix toImage, PixelBounds domain, ImageWrap wrapX, ImageWrap wrapY, bool isSmooth, uint opacity) : Paint
{
    /// <summary>Without a wrap, a pixel whose centre is almost half a device pixel outside still gets the border's colour: the edge of the filled shape
    /// softens it.</summary>
    private const double Tolerance = 0.499;

    public override bool IsOpaque => source.IsOpaque && opacity == 255 && wrapX != ImageWrap.None && wrapY != ImageWrap.None;

    public override void Shade(int x, int y, Span<uint> row)
    {
        var first = new Point(x + 0.5, y + 0.5).Transform(toImage);
        if (isSmooth)
            ShadeSmooth(first.X - 0.5, first.Y - 0.5, row);
        else if (toImage.M12 == 0 && wrapX is ImageWrap.Clamp or ImageWrap.None)
            ShadeNearestRow(first, row);
        else
            ShadeNearest(first, row);
        if (wrapX == ImageWrap.None || wrapY == ImageWrap.None)
            ClearOutside(first, row);
        PixelRows.Scale(row, opacity);
    }

    private void ClearOutside(Point first, Span<uint> row)
    {
        var roomX = Tolerance * (Math.Abs(toImage.M11) + Math.Abs(toImage.M21));
        var roomY = Tolerance * (Math.Abs(toImage.M12) + Math.Abs(toImage.M22));
        for (var i = 0; i < row.Length; i++)
        {
            double u = first.X + i * toImage.M11, v = first.Y + i * toImage.M12;
            if (u < domain.Left - roomX || u > domain.Right + roomX || v < domain.Top - roomY || v > domain.Bottom + roomY)
                row[i] = 0;
        }
    }

    private void ShadeNearestRow(Point first, Span<uint> row)
    {
        var y = Wrapped((int)Math.Floor(first.Y), domain.Top, domain.Bottom, wrapY);
        var pixels = source.Row(y, 0, source.Width);
        for (var i = 0; i < row.Length; i++)
            row[i] = pixels[Math.Clamp((int)(first.X + i * toImage.M11), domain.Left, domain.Right - 1)] | source.AlphaFill;
    }

    private void ShadeNearest(Point first, Span<uint> row)
    {
        for (var i = 0; i < row.Length; i++)
            row[i] = At((int)Math.Floor(first.X + i * toImage.M11), (int)Math.Floor(first.Y + i * toImage.M12));
    }

    private void ShadeSmooth(double u, double v, Span<uint> row)
    {
        for (var i = 0; i < row.Length; i++, u += toImage.M11, v += toImage.M12)
        {
            int x = (int)Math.Floor(u), y = (int)Math.Floor(v);
            uint fractionX = (uint)((u - x) * 256), fractionY = (uint)((v - y) * 256);
            if (x >= domain.Left && y >= domain.Top && x + 1 < domain.Right && y + 1 < domain.Bottom)
            {
                row[i] = PixelArithmetic.Mix(
                    PixelArithmetic.Mix(source[x, y], source[x + 1, y], fractionX),
                    PixelArithmetic.Mix(source[x, y + 1], source[x + 1, y + 1], fractionX),
                    fractionY);
                continue;
            }
            row[i] = PixelArithmetic.Mix(
                PixelArithmetic.Mix(At(x, y), At(x + 1, y), fractionX),
                PixelArithmetic.Mix(At(x, y + 1), At(x + 1, y + 1), fractionX),
                fractionY);
        }
    }

    private uint At(int x, int y) => source[Wrapped(x, domain.Left, domain.Right, wrapX), Wrapped(y, domain.Top, domain.Bottom, wrapY)];

    /// <summary>The coordinate from low to high whose pixel is used for one outside.</summary>
    private static int Wrapped(int value, int low, int high, ImageWrap wrap)
    {
        if (value >= low && value < high)
            return value;
        var size = high - low;
        switch (wrap)
        {
            case ImageWrap.Repeat:
                return low + Modulo(value - low, size);
            case ImageWrap.Mirror:
                var folded = Modulo(value - low, 2 * size);
                return low + (folded < size ? folded : 2 * size - 1 - folded);
            default:
                return Math.Clamp(value, low, high - 1);
        }
    }

    private static int Modulo(int value, int size)
    {
        var rest = value % size;
        return rest < 0 ? rest + size : rest;
    }
}
