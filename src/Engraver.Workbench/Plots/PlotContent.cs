namespace Engraver.Workbench.Plots;

/// <summary>Content of the stacked plots, independent of how it is drawn. Immutable.</summary>
/// <param name="Axis">The common axis.</param>
/// <param name="Panels">Visible plots, from top to bottom; each has data.</param>
/// <param name="Series">The motions, at most one of each role, the planned one first.</param>
/// <param name="Limits">Limits of the job.</param>
public sealed record PlotContent(PlotAxis Axis, IReadOnlyList<PlotPanel> Panels, IReadOnlyList<PlotSeries> Series, IReadOnlyList<PlotLimit> Limits)
{
    public static PlotContent Nothing { get; } = new(PlotAxis.Time, [], [], []);

    /// <summary>End of the longest motion on the common axis; 0 without motions.</summary>
    public double End => Series.Select(series => series.Motion).Where(motion => motion.Count > 0).Select(motion => motion.Along(Axis)[^1]).DefaultIfEmpty().Max();

    /// <summary>The planned motion; null without one.</summary>
    public MotionSeries? Plan => Series.FirstOrDefault(series => series.Role == PlotRole.Plan)?.Motion;

    /// <param name="chosen">The plots that the operator has chosen; those without data are left out.</param>
    public static PlotContent Create(PlotAxis axis, IReadOnlyList<PlotPanel> chosen, IReadOnlyList<PlotSeries> series, IReadOnlyList<PlotLimit> limits) =>
        new(axis, [.. chosen.Where(panel => panel.Quantities.Any(quantity => series.Any(one => one.Motion.Of(quantity) is not null && one.Motion.Count > 0)))], series, limits);
}
