using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;

namespace Engraver.Core.Plots;

/// <summary>The picture of trajectories: the curve that a controller actually runs through their points, coloured by its deviation, over the drawing, with
/// points and corners.</summary>
public static class TrajectoryPlot
{
    /// <summary>Number of separately coloured parts of each step.</summary>
    private const int Parts = 16;

    /// <summary>Maximum number of points drawn; with more points only the curve is drawn.</summary>
    private const int MaxMarks = 20_000;

    /// <param name="analysed">The drawing as it is cut.</param>
    public static PlotModel Create(EntityTable analysed, IReadOnlyList<Trajectory> trajectories, string title)
    {
        ArgumentNullException.ThrowIfNull(trajectories);
        var parts = trajectories.Select(one => TrajectoryCurve.Parts(one, Parts)).ToList();
        var most = parts.SelectMany(one => one).Select(part => part.Deviation).DefaultIfEmpty().Max();
        var drawn = PlotModel.FromDrawing(analysed, title).Strokes.Select(stroke => stroke with { Heat = RunPlot.DrawingBelow });
        var bound = trajectories.Select(one => one.VerifiedBound).DefaultIfEmpty().Max();
        return new PlotModel(title, [.. drawn, .. parts.SelectMany(one => Strokes(one, most))], [], null)
        {
            Heat = new PlotHeat(Wording.Get("Plot.Trajectories", trajectories.Count, trajectories.Sum(one => one.Points), NumberText.Rounded(most, 6), NumberText.Rounded(bound, 6)), "0", NumberText.Rounded(most, 6)),
            Marks = [.. trajectories.SelectMany(Marks).Take(MaxMarks)],
        };
    }

    /// <summary>Neighbours of one colour are one curve.</summary>
    private static IEnumerable<PlotStroke> Strokes(IReadOnlyList<TrajectoryPart> parts, double most)
    {
        var (segments, heat) = (new List<Segment>(), 0);
        foreach (var part in parts)
        {
            var step = most > 0.0 ? Math.Min((int)(part.Deviation / most * RunPlot.Steps), RunPlot.Steps - 1) : 0;
            if (segments.Count > 0 && step != heat)
            {
                yield return new PlotStroke(segments, false, null) { Heat = heat };
                segments = [];
            }

            heat = step;
            segments.Add(part.Curve);
        }

        if (segments.Count > 0) yield return new PlotStroke(segments, false, null) { Heat = heat };
    }

    private static IEnumerable<PlotMark> Marks(Trajectory one) =>
        [.. TrajectoryCurve.CornersOf(one).Select(place => new PlotMark(place, IsCorner: true)), .. one.Lines.Skip(1).SkipLast(1).Select(place => new PlotMark(place, IsCorner: false))];
}
