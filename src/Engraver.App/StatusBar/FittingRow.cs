using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.StatusBar;

/// <summary>A right-aligned row. If it is too narrow for all its children, the first ones are hidden completely, so that text is never cut off: the most
/// important child is the last.</summary>
public sealed class FittingRow : Panel
{
    public static readonly StyledProperty<double> SpacingProperty = AvaloniaProperty.Register<FittingRow, double>(nameof(Spacing));

    static FittingRow() => AffectsMeasure<FittingRow>(SpacingProperty);

    /// <summary>Between two children, units of 1/96 inch.</summary>
    public double Spacing
    {
        get => GetValue(SpacingProperty);
        set => SetValue(SpacingProperty, value);
    }

    protected override Size MeasureOverride(Size availableSize)
    {
        foreach (var child in Children) child.Measure(new Size(double.PositiveInfinity, availableSize.Height));
        var (width, shown) = Shown(availableSize.Width);
        return new Size(width, shown.Count == 0 ? 0 : shown.Max(child => child.DesiredSize.Height));
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        var (_, shown) = Shown(finalSize.Width);
        foreach (var child in Children.Except(shown)) child.Arrange(default);
        var right = finalSize.Width;
        foreach (var child in shown)
        {
            var width = child.DesiredSize.Width;
            child.Arrange(new Rect(right - width, 0, width, finalSize.Height));
            right -= width + Spacing;
        }

        return finalSize;
    }

    /// <summary>The children that fit, from the last on, and their total width.</summary>
    private (double Width, List<Control> Shown) Shown(double room)
    {
        var (width, shown) = (0.0, new List<Control>());
        foreach (var child in Children.Where(child => child.IsVisible).Reverse())
        {
            var next = width + (shown.Count > 0 ? Spacing : 0) + child.DesiredSize.Width;
            if (next > room + 0.5) break;
            width = next;
            shown.Add(child);
        }

        return (width, shown);
    }
}
