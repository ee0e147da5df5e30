namespace Engraver.Workbench.Plots;

/// <summary>One of the stacked plots: quantities of one unit over the common axis.</summary>
public sealed class PlotPanel
{
    /// <summary>The plots at the first start: speed, acceleration, following error and deviation.</summary>
    public const int DefaultMask = 1 + 2 + 4 + 8;

    public const int FullMask = 127;

    private PlotPanel(string key, int mask, params IReadOnlyList<PlotQuantity> quantities) => (Key, Mask, Quantities) = (key, mask, quantities);

    /// <summary>Every plot, from top to bottom.</summary>
    public static IReadOnlyList<PlotPanel> All { get; } =
    [
        new("Speed", 1, PlotQuantity.Speed),
        new("Acceleration", 2, PlotQuantity.AccelerationX, PlotQuantity.AccelerationY),
        new("FollowingError", 4, PlotQuantity.FollowingError),
        new("Deviation", 8, PlotQuantity.Deviation),
        new("FeedOverride", 16, PlotQuantity.FeedOverride),
        new("LinkLoad", 32, PlotQuantity.LinkLoad),
        new("Lag", 64, PlotQuantity.Lag),
    ];

    /// <summary>Name of the plot; its title is a text.</summary>
    public string Key { get; }

    /// <summary>Its number in the system variable CNCPLOTS, a power of two.</summary>
    public int Mask { get; }

    public IReadOnlyList<PlotQuantity> Quantities { get; }
}
