using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paints;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Fills paths and rectangles on a surface, inside a clip.</summary>
internal static class ShapeFiller
{
    /// <param name="isAliased">Pixels are drawn fully or not at all, without soft edges.</param>
    public static void FillPath(SurfacePainter painter, DrawingScratch scratch, VectorPath path, in Matrix transform, Paint paint, ClipShape clip, bool isAliased)
    {
        if (path.ControlBounds(transform) is not { } box)
            return;
        var visible = clip.Visible(PixelBounds.Around(box));
        if (visible.IsEmpty)
            return;
        scratch.Accumulator.Begin(visible);
        scratch.Accumulator.Add(path, transform);
        var sink = new PaintSink(painter, paint, clip);
        if (isAliased)
        {
            var whole = new ThresholdSink<PaintSink>(sink);
            scratch.Accumulator.Emit(ref whole, path.FillRule);
            return;
        }
        scratch.Accumulator.Emit(ref sink, path.FillRule);
    }

    /// <summary>Coverage of a path inside <paramref name="bounds"/>.</summary>
    public static CoverageMask MaskOf(DrawingScratch scratch, VectorPath path, in Matrix transform, PixelBounds bounds)
    {
        var mask = new CoverageMask(bounds);
        if (bounds.IsEmpty)
            return mask;
        scratch.Accumulator.Begin(bounds);
        scratch.Accumulator.Add(path, transform);
        var sink = new MaskSink(mask);
        scratch.Accumulator.Emit(ref sink, path.FillRule);
        return mask;
    }

    /// <summary>Fills a rectangle in device pixels; a border between pixel edges covers its pixels partly.</summary>
    public static void FillRectangle(SurfacePainter painter, Rect device, Paint paint, ClipShape clip)
    {
        var bounds = clip.Bounds;
        double left = Math.Max(device.X, bounds.Left), right = Math.Min(device.Right, bounds.Right);
        double top = Math.Max(device.Y, bounds.Top), bottom = Math.Min(device.Bottom, bounds.Bottom);
        if (!(right > left && bottom > top))
            return;
        for (var y = (int)Math.Floor(top); y < bottom; y++)
        {
            var height = Math.Min(y + 1, bottom) - Math.Max(y, top);
            FillRow(painter, y, left, right, height, paint, clip);
        }
    }

    public static void Clear(SurfacePainter painter, uint pixel, ClipShape clip)
    {
        foreach (var rectangle in clip.Rectangles)
        {
            for (var y = rectangle.Top; y < rectangle.Bottom; y++)
            {
                var row = painter.Surface.Row(y, rectangle.Left, rectangle.Right);
                if (clip.Mask is null)
                    row.Fill(pixel);
                else
                    ClearCovered(row, pixel, clip.Mask.Row(y, rectangle.Left, rectangle.Right));
            }
        }
    }

    private static void ClearCovered(Span<uint> row, uint pixel, ReadOnlySpan<byte> coverage)
    {
        for (var i = 0; i < row.Length; i++)
        {
            if (coverage[i] > 127)
                row[i] = pixel;
        }
    }

    private static void FillRow(SurfacePainter painter, int y, double left, double right, double height, Paint paint, ClipShape clip)
    {
        int first = (int)Math.Floor(left), firstWhole = (int)Math.Ceiling(left), endWhole = (int)Math.Floor(right);
        if (endWhole < firstWhole)
        {
            painter.Run(y, first, first + 1, Coverage(height * (right - left)), paint, clip);
            return;
        }
        if (first < firstWhole)
            painter.Run(y, first, firstWhole, Coverage(height * (firstWhole - left)), paint, clip);
        if (endWhole > firstWhole)
            painter.Run(y, firstWhole, endWhole, Coverage(height), paint, clip);
        if (right > endWhole)
            painter.Run(y, endWhole, endWhole + 1, Coverage(height * (right - endWhole)), paint, clip);
    }

    private static byte Coverage(double area) => (byte)(area * 255 + 0.5);
}

/// <summary>Writes coverage into a mask that holds at least the bounds of the shape.</summary>
internal readonly struct MaskSink(CoverageMask mask) : ICoverageSink
{
    public void Run(int y, int left, int right, byte coverage) => mask.Row(y, left, right).Fill(coverage);

    public void Cells(int y, int left, ReadOnlySpan<byte> coverages) => coverages.CopyTo(mask.Row(y, left, left + coverages.Length));
}

/// <summary>Paints coverage as it arrives.</summary>
internal readonly struct PaintSink(SurfacePainter painter, Paint paint, ClipShape clip) : ICoverageSink
{
    public void Run(int y, int left, int right, byte coverage) => painter.Run(y, left, right, coverage, paint, clip);

    public void Cells(int y, int left, ReadOnlySpan<byte> coverages) => painter.Cells(y, left, coverages, paint, clip);
}
