using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.Shell;

/// <summary>A vertical stack. If the height is not sufficient, the children are distributed over as few columns as fit, of about equal number, to avoid a
/// column with a single child.</summary>
public sealed class BalancedColumns : Panel
{
    protected override Size MeasureOverride(Size availableSize)
    {
        foreach (var child in Children) child.Measure(Size.Infinity);
        var columns = ColumnsFor(availableSize.Height);
        return new Size(columns.Sum(WidthOf), columns.Select(HeightOf).DefaultIfEmpty().Max());
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        var left = 0.0;
        foreach (var column in ColumnsFor(finalSize.Height))
        {
            var (top, width) = (0.0, WidthOf(column));
            foreach (var child in column)
            {
                child.Arrange(new Rect(left, top, width, child.DesiredSize.Height));
                top += child.DesiredSize.Height;
            }

            left += width;
        }

        return finalSize;
    }

    private static double WidthOf(Control[] column) => column.Max(child => child.DesiredSize.Width);

    private static double HeightOf(Control[] column) => column.Sum(child => child.DesiredSize.Height);

    /// <summary>The smallest number of columns that fit in the height; one child each if nothing fits.</summary>
    private List<Control[]> ColumnsFor(double room)
    {
        for (var count = 1; count < Children.Count; count++)
        {
            var columns = Children.Chunk((Children.Count + count - 1) / count).ToList();
            if (columns.All(column => HeightOf(column) <= room + 0.5)) return columns;
        }

        return [.. Children.Chunk(1)];
    }
}
