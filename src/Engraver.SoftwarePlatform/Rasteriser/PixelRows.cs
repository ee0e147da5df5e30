using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Blending of whole rows, four pixels at a time. Results are equal, bit for bit, to <see cref="ScalarPixelRows"/>.</summary>
internal static class PixelRows
{
    /// <summary>Pixels that are blended at a time.</summary>
    public const int Lane = 4;

    private static readonly Vector128<byte> s_alphaOfEach = Vector128.Create((byte)3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11, 11, 15, 15, 15, 15);
    private static readonly Vector128<byte> s_byteOfEach = Vector128.Create((byte)0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);

    /// <summary>Row = color over row.</summary>
    public static void BlendColor(Span<uint> row, uint color)
    {
        if (color >> 24 == 255)
        {
            row.Fill(color);
            return;
        }
        var source = Vector128.Create(color).AsByte();
        var rest = Vector128.Create((ushort)(255 - (color >> 24)));
        var i = 0;
        for (; i <= row.Length - Lane; i += Lane)
            Store(row, i, source + Scaled(Load(row, i), rest, rest));
        ScalarPixelRows.BlendColor(row[i..], color);
    }

    /// <summary>Row = color, as far as each pixel is covered, over row.</summary>
    public static void BlendColor(Span<uint> row, uint color, ReadOnlySpan<byte> coverage)
    {
        var source = Vector128.Create(color).AsByte();
        var i = 0;
        for (; i <= row.Length - Lane; i += Lane)
        {
            var four = FourBytes(coverage, i);
            if (four != 0)
                Store(row, i, Over(Scaled(source, four), Load(row, i)));
        }
        ScalarPixelRows.BlendColor(row[i..], color, coverage[i..]);
    }

    /// <summary>Colour, as far as each pixel is covered, over all rows of a rectangle, which must be on the surface.</summary>
    /// <param name="coverage">Row by row.</param>
    /// <param name="width">Pixels of a row, a multiple of <see cref="Lane"/>.</param>
    public static void BlendColor(PixelSurface surface, int left, int top, uint color, ReadOnlySpan<byte> coverage, int width)
    {
        var source = Vector128.Create(color).AsByte();
        for (; !coverage.IsEmpty; coverage = coverage[width..], top++)
        {
            var row = surface.Row(top, left, left + width);
            for (var i = 0; i < width; i += Lane)
                Store(row, i, Over(Scaled(source, FourBytes(coverage, i)), Load(row, i)));
        }
    }

    /// <summary>Row = source over row.</summary>
    public static void BlendPixels(Span<uint> row, ReadOnlySpan<uint> source)
    {
        var i = 0;
        for (; i <= row.Length - Lane; i += Lane)
            Store(row, i, Over(Load(source, i), Load(row, i)));
        ScalarPixelRows.BlendPixels(row[i..], source[i..]);
    }

    public static void Scale(Span<uint> row, uint factor)
    {
        if (factor == 255)
            return;
        var wide = Vector128.Create((ushort)factor);
        var i = 0;
        for (; i <= row.Length - Lane; i += Lane)
            Store(row, i, Scaled(Load(row, i), wide, wide));
        ScalarPixelRows.Scale(row[i..], factor);
    }

    public static void Scale(Span<uint> row, ReadOnlySpan<byte> coverage)
    {
        var i = 0;
        for (; i <= row.Length - Lane; i += Lane)
            Store(row, i, Scaled(Load(row, i), FourBytes(coverage, i)));
        ScalarPixelRows.Scale(row[i..], coverage[i..]);
    }

    /// <summary>Coverage = coverage * other / 255.</summary>
    public static void Multiply(Span<byte> coverage, ReadOnlySpan<byte> other)
    {
        var i = 0;
        for (; i <= coverage.Length - Vector128<byte>.Count; i += Vector128<byte>.Count)
        {
            var (low, high) = Vector128.Widen(Vector128.Create<byte>(other[i..]));
            Scaled(Vector128.Create<byte>(coverage[i..]), low, high).CopyTo(coverage[i..]);
        }
        ScalarPixelRows.Multiply(coverage[i..], other[i..]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Over(Vector128<byte> source, Vector128<byte> destination)
    {
        var (low, high) = Vector128.Widen(~Vector128.Shuffle(source, s_alphaOfEach));
        return source + Scaled(destination, low, high);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Scaled(Vector128<byte> pixels, uint fourFactors)
    {
        var (low, high) = Vector128.Widen(Vector128.Shuffle(Vector128.CreateScalar(fourFactors).AsByte(), s_byteOfEach));
        return Scaled(pixels, low, high);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Scaled(Vector128<byte> pixels, Vector128<ushort> lowFactor, Vector128<ushort> highFactor)
    {
        var (low, high) = Vector128.Widen(pixels);
        return Vector128.Narrow(Divided(low * lowFactor), Divided(high * highFactor));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<ushort> Divided(Vector128<ushort> products)
    {
        var rounded = products + Vector128.Create((ushort)128);
        return (rounded + (rounded >>> 8)) >>> 8;
    }

    private static Vector128<byte> Load(ReadOnlySpan<uint> row, int index) => Vector128.LoadUnsafe(ref MemoryMarshal.GetReference(row), (nuint)index).AsByte();

    private static void Store(Span<uint> row, int index, Vector128<byte> pixels) => pixels.AsUInt32().StoreUnsafe(ref MemoryMarshal.GetReference(row), (nuint)index);

    private static uint FourBytes(ReadOnlySpan<byte> bytes, int index) => MemoryMarshal.Read<uint>(bytes.Slice(index, Lane));
}
