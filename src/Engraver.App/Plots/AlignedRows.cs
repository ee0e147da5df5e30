using ScottPlot;

namespace Engraver.App.Plots;

/// <summary>Rows whose fields have the same height: the last row also has the numbers and the title of the common axis.</summary>
/// <param name="axisHeight">Height of numbers and title, pixels.</param>
internal sealed class AlignedRows(float axisHeight) : IMultiplotLayout
{
    public PixelRect[] GetSubplotRectangles(SubplotCollection subplots, PixelRect figureRect)
    {
        var (count, top) = (subplots.Count, figureRect.Top);
        var height = Math.Max(0.0f, figureRect.Height - axisHeight) / Math.Max(count, 1);
        var rows = new PixelRect[count];
        for (var i = 0; i < count; i++)
        {
            var bottom = i < count - 1 ? top + height : figureRect.Bottom;
            rows[i] = new PixelRect(figureRect.Left, figureRect.Right, bottom, top);
            top = bottom;
        }

        return rows;
    }
}
