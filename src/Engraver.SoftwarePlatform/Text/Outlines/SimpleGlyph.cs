using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Text.Outlines;

/// <summary>Contours of a TrueType glyph: points on the curve and control points between them (OpenType 1.9, glyf, "Simple glyph description").</summary>
internal static class SimpleGlyph
{
    private const byte OnCurve = 1;
    private const byte XIsByte = 2;
    private const byte YIsByte = 4;
    private const byte Repeats = 8;
    private const byte XSameOrPositive = 16;
    private const byte YSameOrPositive = 32;

    public static void Add(VectorPath path, FontBytes data, int contours, in Matrix transform)
    {
        if (contours == 0)
            return;
        var count = data.UInt16(10 + 2 * (contours - 1)) + 1;
        var offset = 10 + 2 * contours;
        offset += 2 + data.UInt16(offset);
        var flags = Flags(data, count, ref offset);
        var xs = Coordinates(data, flags, XIsByte, XSameOrPositive, ref offset);
        var ys = Coordinates(data, flags, YIsByte, YSameOrPositive, ref offset);
        var points = new Point[count];
        for (var i = 0; i < count; i++)
            points[i] = new Point(xs[i], ys[i]).Transform(transform);
        var first = 0;
        for (var contour = 0; contour < contours; contour++)
        {
            var end = data.UInt16(10 + 2 * contour) + 1;
            if (end < first || end > count)
                throw new BrokenFontException("The contours of a glyph are out of order.");
            AddContour(path, points.AsSpan(first, end - first), flags.AsSpan(first, end - first));
            first = end;
        }
    }

    private static byte[] Flags(FontBytes data, int count, ref int offset)
    {
        var flags = new byte[count];
        for (var i = 0; i < count;)
        {
            var flag = data.Byte(offset++);
            var times = (flag & Repeats) != 0 ? 1 + data.Byte(offset++) : 1;
            for (; times > 0 && i < count; times--)
                flags[i++] = flag;
        }
        return flags;
    }

    private static int[] Coordinates(FontBytes data, byte[] flags, byte isByte, byte sameOrPositive, ref int offset)
    {
        var values = new int[flags.Length];
        var value = 0;
        for (var i = 0; i < flags.Length; i++)
        {
            var marked = (flags[i] & sameOrPositive) != 0;
            if ((flags[i] & isByte) != 0)
            {
                var step = data.Byte(offset++);
                value += marked ? step : -step;
            }
            else if (!marked)
            {
                value += data.Int16(offset);
                offset += 2;
            }
            values[i] = value;
        }
        return values;
    }

    /// <summary>A point on the curve is implied halfway between two consecutive control points.</summary>
    private static void AddContour(VectorPath path, ReadOnlySpan<Point> points, ReadOnlySpan<byte> flags)
    {
        if (points.Length < 2)
            return;
        var count = points.Length;
        var first = 0;
        while (first < count && (flags[first] & OnCurve) == 0)
            first++;
        var start = first < count ? points[first] : Middle(points[0], points[count - 1]);
        path.MoveTo(start);
        var after = first < count ? first + 1 : 0;
        var remaining = first < count ? count - 1 : count;
        for (var i = 0; i < remaining; i++)
        {
            var current = (after + i) % count;
            if ((flags[current] & OnCurve) != 0)
            {
                path.LineTo(points[current]);
                continue;
            }
            var next = (current + 1) % count;
            var isLast = i == remaining - 1;
            var nextIsOn = !isLast && (flags[next] & OnCurve) != 0;
            path.QuadraticTo(points[current], isLast ? start : nextIsOn ? points[next] : Middle(points[current], points[next]));
            if (nextIsOn)
                i++;
        }
        path.Close();
    }

    private static Point Middle(Point a, Point b) => new((a.X + b.X) / 2, (a.Y + b.Y) / 2);
}
