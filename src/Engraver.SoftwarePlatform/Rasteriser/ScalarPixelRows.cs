namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>The same as <see cref="PixelRows"/>, pixel by pixel: used for ends of rows, on computers without vector instructions, and as the reference in
/// tests.</summary>
internal static class ScalarPixelRows
{
    public static void BlendColor(Span<uint> row, uint color)
    {
        var rest = 255 - (color >> 24);
        for (var i = 0; i < row.Length; i++)
            row[i] = color + PixelArithmetic.Scale(row[i], rest);
    }

    public static void BlendColor(Span<uint> row, uint color, ReadOnlySpan<byte> coverage)
    {
        for (var i = 0; i < row.Length; i++)
            row[i] = PixelArithmetic.Over(PixelArithmetic.Scale(color, coverage[i]), row[i]);
    }

    public static void BlendPixels(Span<uint> row, ReadOnlySpan<uint> source)
    {
        for (var i = 0; i < row.Length; i++)
            row[i] = PixelArithmetic.Over(source[i], row[i]);
    }

    public static void Scale(Span<uint> row, uint factor)
    {
        for (var i = 0; i < row.Length; i++)
            row[i] = PixelArithmetic.Scale(row[i], factor);
    }

    public static void Scale(Span<uint> row, ReadOnlySpan<byte> coverage)
    {
        for (var i = 0; i < row.Length; i++)
            row[i] = PixelArithmetic.Scale(row[i], coverage[i]);
    }

    public static void Multiply(Span<byte> coverage, ReadOnlySpan<byte> other)
    {
        for (var i = 0; i < coverage.Length; i++)
            coverage[i] = (byte)PixelArithmetic.Multiply(coverage[i], other[i]);
    }
}
