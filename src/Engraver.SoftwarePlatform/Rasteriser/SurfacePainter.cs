using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Draws spans of a paint onto a surface, inside a clip.</summary>
internal sealed class SurfacePainter(PixelSurface surface, DrawingScratch scratch)
{
    private const int LongestSpan = DrawingScratch.LongestSpan;

    public PixelSurface Surface => surface;

    /// <summary>Equal coverage along a row.</summary>
    public void Run(int y, int left, int right, byte coverage, Paint paint, ClipShape clip)
    {
        foreach (var rectangle in clip.Rectangles)
        {
            if (y < rectangle.Top || y >= rectangle.Bottom)
                continue;
            var end = Math.Min(right, rectangle.Right);
            for (var from = Math.Max(left, rectangle.Left); from < end; from += LongestSpan)
                PaintRun(y, from, Math.Min(end, from + LongestSpan), coverage, paint, clip.Mask);
        }
    }

    /// <summary>One coverage for each pixel from <paramref name="left"/> on.</summary>
    public void Cells(int y, int left, ReadOnlySpan<byte> coverages, Paint paint, ClipShape clip)
    {
        foreach (var rectangle in clip.Rectangles)
        {
            if (y < rectangle.Top || y >= rectangle.Bottom)
                continue;
            var end = Math.Min(left + coverages.Length, rectangle.Right);
            for (var from = Math.Max(left, rectangle.Left); from < end; from += LongestSpan)
            {
                var to = Math.Min(end, from + LongestSpan);
                PaintCells(y, from, to, coverages[(from - left)..(to - left)], paint, clip.Mask);
            }
        }
    }

    private void PaintRun(int y, int left, int right, byte coverage, Paint paint, CoverageMask? mask)
    {
        if (mask is not null || !paint.IsPlainOver)
        {
            var covered = scratch.Covered.AsSpan(0, right - left);
            covered.Fill(coverage);
            PaintCells(y, left, right, covered, paint, mask);
            return;
        }
        var row = surface.Row(y, left, right);
        if (paint is SolidPaint solid)
        {
            PixelRows.BlendColor(row, PixelArithmetic.Scale(solid.Color, coverage));
            return;
        }
        if (coverage == 255 && paint.IsOpaque)
        {
            paint.Shade(left, y, row);
            return;
        }
        var shaded = scratch.Shaded.AsSpan(0, right - left);
        paint.Shade(left, y, shaded);
        PixelRows.Scale(shaded, coverage);
        PixelRows.BlendPixels(row, shaded);
    }

    private void PaintCells(int y, int left, int right, ReadOnlySpan<byte> coverages, Paint paint, CoverageMask? mask)
    {
        if (mask is not null)
        {
            var covered = scratch.Covered.AsSpan(0, right - left);
            coverages.CopyTo(covered);
            PixelRows.Multiply(covered, mask.Row(y, left, right));
            coverages = covered;
        }
        var row = surface.Row(y, left, right);
        if (paint is SolidPaint solid)
        {
            PixelRows.BlendColor(row, solid.Color, coverages);
            return;
        }
        var shaded = scratch.Shaded.AsSpan(0, right - left);
        paint.Shade(left, y, shaded);
        if (!paint.IsPlainOver)
        {
            Mix(row, shaded, coverages, paint);
            return;
        }
        PixelRows.Scale(shaded, coverages);
        PixelRows.BlendPixels(row, shaded);
    }

    private static void Mix(Span<uint> row, ReadOnlySpan<uint> shaded, ReadOnlySpan<byte> coverages, Paint paint)
    {
        for (var i = 0; i < row.Length; i++)
        {
            var mixed = PixelBlending.Blend(paint.Mode, shaded[i], row[i]);
            row[i] = PixelArithmetic.Scale(mixed, coverages[i]) + PixelArithmetic.Scale(row[i], 255u - coverages[i]);
        }
    }
}
