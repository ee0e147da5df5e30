namespace Engraver.Workbench.Plots;

/// <summary>What plots are drawn over.</summary>
public enum PlotAxis
{
    /// <summary>Seconds since the start of the motion.</summary>
    Time,

    /// <summary>Millimetres of the path travelled since the start of the motion, with the tool on or off.</summary>
    Path,
}
