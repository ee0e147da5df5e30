namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>The points of a TrueType glyph without components (OpenType 1.9, glyf, "Simple glyph description").</summary>
internal static class SimpleGlyph
{
    private const byte OnCurve = 1;
    private const byte XIsByte = 2;
    private const byte YIsByte = 4;
    private const byte Repeats = 8;
    private const byte XSameOrPositive = 16;
    private const byte YSameOrPositive = 32;

    public static void Read(GlyphPoints points, FontBytes data, int contours)
    {
        if (contours == 0)
            return;
        var count = data.UInt16(10 + 2 * (contours - 1)) + 1;
        var offset = 10 + 2 * contours;
        offset += 2 + data.UInt16(offset);
        var flags = Flags(data, count, ref offset);
        var xs = Coordinates(data, flags, XIsByte, XSameOrPositive, ref offset);
        var ys = Coordinates(data, flags, YIsByte, YSameOrPositive, ref offset);
        var first = 0;
        for (var contour = 0; contour < contours; contour++)
        {
            var end = data.UInt16(10 + 2 * contour) + 1;
            if (end < first || end > count)
                throw new BrokenFontException("The contours of a glyph are out of order.");
            for (var i = first; i < end; i++)
                points.Add(new FontPoint(xs[i], ys[i]), (flags[i] & OnCurve) != 0);
            points.EndContour();
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
}
