using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Tests.Rasteriser;

/// <summary>Four pixels at a time must give the same result as one at a time, for every length and every value.</summary>
public class PixelRowsTests
{
    private readonly Random _random = new(20261121);

    [Fact]
    public void Multiplying_bytes_is_exact_for_all_pairs()
    {
        for (var a = 0u; a < 256; a++)
        {
            for (var b = 0u; b < 256; b++)
                Assert.Equal((uint)Math.Round(a * b / 255.0, MidpointRounding.AwayFromZero), PixelArithmetic.Multiply(a, b));
        }
    }

    [Fact]
    public void A_color_over_a_row() => CompareAll((row, other, coverage, plain) =>
    {
        if (plain)
            ScalarPixelRows.BlendColor(row, other[0]);
        else
            PixelRows.BlendColor(row, other[0]);
    });

    [Fact]
    public void A_covered_color_over_a_row() => CompareAll((row, other, coverage, plain) =>
    {
        if (plain)
            ScalarPixelRows.BlendColor(row, other[0], coverage);
        else
            PixelRows.BlendColor(row, other[0], coverage);
    });

    [Fact]
    public unsafe void A_covered_color_over_a_rectangle()
    {
        const int surfaceWidth = 23, left = 3, top = 2, width = 2 * PixelRows.Lane, height = 5;
        for (var round = 0; round < 50; round++)
        {
            uint[] surface = Pixels(surfaceWidth * 10), expected = [.. surface];
            var color = Pixels(1)[0];
            var coverage = Coverage(width * height);
            for (var y = 0; y < height; y++)
                ScalarPixelRows.BlendColor(expected.AsSpan((top + y) * surfaceWidth + left, width), color, coverage.AsSpan(y * width, width));
            fixed (uint* pixels = surface)
                PixelRows.BlendColor(new PixelSurface(pixels, surfaceWidth, new PixelBounds(0, 0, surfaceWidth, 10)), left, top, color, coverage, width);
            Assert.Equal(expected, surface);
        }
    }

    [Fact]
    public void Pixels_over_a_row() => CompareAll((row, other, coverage, plain) =>
    {
        if (plain)
            ScalarPixelRows.BlendPixels(row, other);
        else
            PixelRows.BlendPixels(row, other);
    });

    [Fact]
    public void A_row_scaled_by_one_factor() => CompareAll((row, other, coverage, plain) =>
    {
        if (plain)
            ScalarPixelRows.Scale(row, (uint)coverage[0]);
        else
            PixelRows.Scale(row, (uint)coverage[0]);
    });

    [Fact]
    public void A_row_scaled_by_coverage() => CompareAll((row, other, coverage, plain) =>
    {
        if (plain)
            ScalarPixelRows.Scale(row, coverage);
        else
            PixelRows.Scale(row, coverage);
    });

    [Fact]
    public void Coverage_times_coverage()
    {
        for (var length = 0; length < 70; length++)
        {
            byte[] first = Coverage(length), second = Coverage(length), expected = [.. first];
            ScalarPixelRows.Multiply(expected, second);
            PixelRows.Multiply(first, second);
            Assert.Equal(expected, first);
        }
    }

    private void CompareAll(Action<uint[], uint[], byte[], bool> operation)
    {
        for (var length = 1; length < 40; length++)
        {
            for (var round = 0; round < 20; round++)
            {
                uint[] row = Pixels(length), other = Pixels(length), expected = [.. row];
                var coverage = Coverage(length);
                operation(expected, other, coverage, true);
                operation(row, other, coverage, false);
                Assert.Equal(expected, row);
            }
        }
    }

    private uint[] Pixels(int length) => [.. Enumerable.Range(0, length).Select(_ => PixelArithmetic.Premultiplied((uint)_random.NextInt64(1L << 32)))];

    private byte[] Coverage(int length) => [.. Enumerable.Range(0, length).Select(_ => (byte)(_random.Next(3) == 0 ? 255 * _random.Next(2) : _random.Next(256)))];
}
