namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>A glyph that is part of another one (OpenType 1.9, glyf, "Composite glyph description"): scaled or rotated, then moved by an offset, or until one
/// of its points is at one of the glyph so far.</summary>
/// <param name="First">Offset to the right, or the number of the point of the glyph so far.</param>
/// <param name="Second">Offset upwards, or the number of the point of the component.</param>
internal readonly record struct GlyphComponent(int Glyph, int First, int Second, bool IsPlacedByPoints, GlyphScale Scale, bool HasMore)
{
    private const int ArgumentsAreWords = 0x0001;
    private const int ArgumentsAreOffsets = 0x0002;
    private const int HasMoreComponents = 0x0020;

    public static GlyphComponent Read(FontBytes data, ref int offset)
    {
        int flags = data.UInt16(offset), glyph = data.UInt16(offset + 2);
        offset += 4;
        var areOffsets = (flags & ArgumentsAreOffsets) != 0;
        int first, second;
        if ((flags & ArgumentsAreWords) != 0)
        {
            first = areOffsets ? data.Int16(offset) : data.UInt16(offset);
            second = areOffsets ? data.Int16(offset + 2) : data.UInt16(offset + 2);
            offset += 4;
        }
        else
        {
            first = areOffsets ? (sbyte)data.Byte(offset) : data.Byte(offset);
            second = areOffsets ? (sbyte)data.Byte(offset + 1) : data.Byte(offset + 1);
            offset += 2;
        }
        return new GlyphComponent(glyph, first, second, !areOffsets, GlyphScale.Read(data, flags, ref offset), (flags & HasMoreComponents) != 0);
    }

    /// <param name="compound">The first point of the glyph that the component is part of.</param>
    /// <param name="first">The first point of the component, in the component's own coordinates.</param>
    public void Place(GlyphPoints points, int compound, int first)
    {
        var scale = Scale;
        double dx = First, dy = Second;
        if (IsPlacedByPoints)
        {
            if (compound + First >= first)
                throw new BrokenFontException("A component of a glyph is placed by a point of its own.");
            FontPoint target = points[compound + First], own = scale.Of(points[first + Second]);
            dx = target.X - own.X;
            dy = target.Y - own.Y;
        }
        points.Change(first, point => Moved(scale.Of(point), dx, dy));
    }

    private static FontPoint Moved(FontPoint point, double dx, double dy) => new(point.X + dx, point.Y + dy);
}

/// <summary>A matrix of two rows: x = XX x + YX y, y = XY x + YY y.</summary>
internal readonly record struct GlyphScale(double XX, double XY, double YX, double YY)
{
    private const int HasScale = 0x0008;
    private const int HasTwoScales = 0x0040;
    private const int HasMatrix = 0x0080;

    public static GlyphScale Read(FontBytes data, int flags, ref int offset)
    {
        double xx = 1, xy = 0, yx = 0, yy = 1;
        if ((flags & HasScale) != 0)
        {
            xx = yy = Fraction(data, ref offset);
        }
        else if ((flags & HasTwoScales) != 0)
        {
            xx = Fraction(data, ref offset);
            yy = Fraction(data, ref offset);
        }
        else if ((flags & HasMatrix) != 0)
        {
            xx = Fraction(data, ref offset);
            xy = Fraction(data, ref offset);
            yx = Fraction(data, ref offset);
            yy = Fraction(data, ref offset);
        }
        return new GlyphScale(xx, xy, yx, yy);
    }

    public FontPoint Of(FontPoint point) => new(point.X * XX + point.Y * YX, point.X * XY + point.Y * YY);

    /// <summary>A signed number with 14 bits after the binary point.</summary>
    private static double Fraction(FontBytes data, ref int offset)
    {
        var value = data.Int16(offset) / 16384.0;
        offset += 2;
        return value;
    }
}
