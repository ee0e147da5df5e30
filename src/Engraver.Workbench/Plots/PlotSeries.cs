namespace Engraver.Workbench.Plots;

/// <summary>A motion in the plots.</summary>
/// <param name="Role">Its place among the others, which selects name and colour.</param>
/// <param name="Name">File name of a stored run; empty for the others.</param>
/// <param name="Motion">Its samples.</param>
public sealed record PlotSeries(PlotRole Role, string Name, MotionSeries Motion);
