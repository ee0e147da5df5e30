using Avalonia;

namespace Engraver.SoftwarePlatform.Text.Outlines;

/// <summary>A glyph that is part of another one (OpenType 1.9, glyf, "Composite glyph description"). Components placed by matching points are put at the
/// origin.</summary>
internal readonly record struct GlyphComponent(int Glyph, Matrix Transform, bool HasMore)
{
    private const int ArgumentsAreWords = 0x0001;
    private const int ArgumentsAreOffsets = 0x0002;
    private const int HasScale = 0x0008;
    private const int HasMoreComponents = 0x0020;
    private const int HasTwoScales = 0x0040;
    private const int HasMatrix = 0x0080;

    public static GlyphComponent Read(FontBytes data, ref int offset)
    {
        int flags = data.UInt16(offset), glyph = data.UInt16(offset + 2);
        offset += 4;
        var place = Place(data, flags, ref offset);
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
        return new GlyphComponent(glyph, new Matrix(xx, xy, yx, yy, place.X, place.Y), (flags & HasMoreComponents) != 0);
    }

    private static Vector Place(FontBytes data, int flags, ref int offset)
    {
        var isWide = (flags & ArgumentsAreWords) != 0;
        var place = isWide
            ? new Vector(data.Int16(offset), data.Int16(offset + 2))
            : new Vector((sbyte)data.Byte(offset), (sbyte)data.Byte(offset + 1));
        offset += isWide ? 4 : 2;
        return (flags & ArgumentsAreOffsets) != 0 ? place : default;
    }

    /// <summary>A signed number with 14 bits after the binary point.</summary>
    private static double Fraction(FontBytes data, ref int offset)
    {
        var value = data.Int16(offset) / 16384.0;
        offset += 2;
        return value;
    }
}
