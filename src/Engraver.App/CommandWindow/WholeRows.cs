using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.CommandWindow;

/// <summary>Gives its child a height of whole rows, aligned to the bottom, so that the first visible row is not cut off.</summary>
public sealed class WholeRows : Decorator
{
    /// <summary>Of one row, units of 1/96 inch.</summary>
    private const double RowHeight = 18;

    protected override Size MeasureOverride(Size availableSize)
    {
        Child?.Measure(availableSize.WithHeight(RoundDownToRows(availableSize.Height)));
        return Child?.DesiredSize ?? default;
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        var height = RoundDownToRows(finalSize.Height);
        Child?.Arrange(new Rect(0, finalSize.Height - height, finalSize.Width, height));
        return finalSize;
    }

    private static double RoundDownToRows(double room) => double.IsFinite(room) && room >= RowHeight ? Math.Floor(room / RowHeight) * RowHeight : room;
}
