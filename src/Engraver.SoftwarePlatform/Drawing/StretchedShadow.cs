using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>A mask whose middle row and column are stretched to fill a larger box.</summary>
/// <param name="bounds">Position of the stretched mask; at least as large as the mask.</param>
internal readonly struct StretchedShadow(CoverageMask mask, PixelBounds bounds)
{
    private int MiddleX => mask.Bounds.Left + mask.Bounds.Width / 2;

    private int MiddleY => mask.Bounds.Top + mask.Bounds.Height / 2;

    public void Paint(ContextStack state, Paint paint)
    {
        var visible = state.Clip.Visible(bounds);
        int leftEnd = bounds.Left + mask.Bounds.Width / 2, rightStart = leftEnd + bounds.Width - mask.Bounds.Width + 1;
        for (var y = visible.Top; y < visible.Bottom; y++)
        {
            var row = mask.Row(SourceRow(y), mask.Bounds.Left, mask.Bounds.Right);
            state.Painter.Cells(y, bounds.Left, row[..(MiddleX - mask.Bounds.Left)], paint, state.Clip);
            if (row[MiddleX - mask.Bounds.Left] is > 0 and var coverage)
                state.Painter.Run(y, leftEnd, rightStart, coverage, paint, state.Clip);
            state.Painter.Cells(y, rightStart, row[(MiddleX - mask.Bounds.Left + 1)..], paint, state.Clip);
        }
    }

    /// <summary>The stretched mask as a mask of its own, which may be changed.</summary>
    public CoverageMask ToMask()
    {
        var whole = new CoverageMask(bounds);
        int left = mask.Bounds.Width / 2, right = mask.Bounds.Width - left - 1;
        for (var y = bounds.Top; y < bounds.Bottom; y++)
        {
            var source = mask.Row(SourceRow(y), mask.Bounds.Left, mask.Bounds.Right);
            var target = whole.Row(y, bounds.Left, bounds.Right);
            source[..left].CopyTo(target);
            target[left..^right].Fill(source[left]);
            source[(left + 1)..].CopyTo(target[^right..]);
        }
        return whole;
    }

    private int SourceRow(int y)
    {
        var fromTop = y - bounds.Top + mask.Bounds.Top;
        var fromBottom = y - bounds.Bottom + mask.Bounds.Bottom;
        return Math.Max(Math.Min(fromTop, MiddleY), fromBottom);
    }
}
