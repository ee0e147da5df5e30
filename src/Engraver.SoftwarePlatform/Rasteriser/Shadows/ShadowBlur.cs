using System.Buffers;

namespace Engraver.SoftwarePlatform.Rasteriser.Shadows;

/// <summary>Three means over a sliding window in each direction, which together approximate a Gaussian.</summary>
/// <remarks>The three numbers are the odd lengths of the windows in pixels.</remarks>
internal readonly record struct ShadowBlur(int First, int Second, int Third)
{
    /// <summary>Distance in pixels over which the blur spreads.</summary>
    public int Reach => (First + Second + Third) / 2 + 1;

    public bool IsNone => First + Second + Third == 3;

    /// <param name="radius">Blur radius of a box shadow in device pixels; a Gaussian of 0.2887 radii plus half a pixel, as Avalonia has it.</param>
    public static ShadowBlur FromRadius(double radius)
    {
        if (radius <= 0)
            return new ShadowBlur(1, 1, 1);
        var sigma = 0.288675 * radius + 0.5;
        var ideal = Math.Sqrt(4 * sigma * sigma + 1);
        var low = Math.Max(1, (int)ideal);
        if (low % 2 == 0)
            low--;
        var lowCount = (12 * sigma * sigma - 3.0 * low * low - 12.0 * low - 9) / (-4.0 * low - 4);
        var narrow = Math.Clamp((int)Math.Round(lowCount), 0, 3);
        return new ShadowBlur(narrow > 0 ? low : low + 2, narrow > 1 ? low : low + 2, narrow > 2 ? low : low + 2);
    }

    public void Apply(CoverageMask mask)
    {
        if (IsNone)
            return;
        var longest = Math.Max(mask.Bounds.Width, mask.Bounds.Height);
        var line = ArrayPool<byte>.Shared.Rent(longest);
        try
        {
            foreach (var window in (ReadOnlySpan<int>)[First, Second, Third])
            {
                for (var y = 0; y < mask.Bounds.Height; y++)
                    Slide(mask.Cells.Slice(y * mask.Bounds.Width, mask.Bounds.Width), 1, mask.Bounds.Width, window, line);
                for (var x = 0; x < mask.Bounds.Width; x++)
                    Slide(mask.Cells[x..], mask.Bounds.Width, mask.Bounds.Height, window, line);
            }
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(line);
        }
    }

    /// <summary>Replaces every cell of a row or column by the mean over the window around it; the outermost cells are repeated outside.</summary>
    private static void Slide(Span<byte> cells, int step, int count, int window, byte[] line)
    {
        for (var i = 0; i < count; i++)
            line[i] = cells[i * step];
        var half = window / 2;
        var sum = 0;
        for (var i = -half; i <= half; i++)
            sum += line[Math.Clamp(i, 0, count - 1)];
        for (var i = 0; i < count; i++)
        {
            cells[i * step] = (byte)((sum + half) / window);
            sum += line[Math.Min(i + half + 1, count - 1)] - line[Math.Max(i - half, 0)];
        }
    }
}
