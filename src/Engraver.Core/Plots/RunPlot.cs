using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Plots;

/// <summary>The picture of a run: the tool positions over the drawing, coloured by a measure from its minimum to its maximum.</summary>
public static class RunPlot
{
    /// <summary>Number of colour steps.</summary>
    public const int Steps = 16;

    /// <summary>The drawing under the run has no measure.</summary>
    public const int DrawingBelow = -1;

    /// <param name="analysed">The drawing as it is cut.</param>
    /// <param name="trace">Only positions with the tool on are shown.</param>
    public static PlotModel Create(EntityTable analysed, RunTrace trace, RunMeasure measure, string title)
    {
        ArgumentNullException.ThrowIfNull(trace);
        var drawn = PlotModel.FromDrawing(analysed, title).Strokes.Select(stroke => stroke with { Heat = DrawingBelow });
        var values = Values(trace, measure);
        var most = trace.Places.Select((place, i) => place.ToolOn ? values[i] : 0.0).DefaultIfEmpty().Max();
        return new PlotModel(title, [.. drawn, .. Run(trace, values, most)], [], null) { Heat = new PlotHeat(Caption(trace, measure), "0", NumberText.Rounded(most, 4)) };
    }

    /// <summary>Meaning of the colour, and its largest value while the tool was on.</summary>
    public static string Caption(RunTrace trace, RunMeasure measure)
    {
        ArgumentNullException.ThrowIfNull(trace);
        var values = Values(trace, measure);
        var most = trace.Places.Select((place, i) => place.ToolOn ? values[i] : 0.0).DefaultIfEmpty().Max();
        return Wording.Get(measure switch { RunMeasure.Deviation => "Plot.Deviation", RunMeasure.Following => "Plot.Following", _ => "Plot.Speed" }, NumberText.Rounded(most, 4), trace.Source, trace.Places.Count(place => place.ToolOn));
    }

    /// <summary>One value for each place: millimetres, for the speed mm/min. An unknown value is 0.</summary>
    public static double[] Values(RunTrace trace, RunMeasure measure)
    {
        ArgumentNullException.ThrowIfNull(trace);
        return [.. trace.Places.Select((place, i) => measure switch { RunMeasure.Deviation => place.DeviationMm, RunMeasure.Following => place.FollowingMm ?? 0.0, _ => trace.SpeedTo(i) * 60.0 })];
    }

    /// <summary>Neighbours of one colour are one curve.</summary>
    private static IEnumerable<PlotStroke> Run(RunTrace trace, double[] values, double most)
    {
        var (segments, heat) = (new List<Segment>(), 0);
        for (var i = 1; i < trace.Places.Count; i++)
        {
            var (from, to) = (trace.Places[i - 1], trace.Places[i]);
            if (!to.ToolOn || !from.ToolOn || from.Place == to.Place) continue;
            var step = most > 0.0 ? Math.Min((int)(values[i] / most * Steps), Steps - 1) : 0;
            if (segments.Count > 0 && (step != heat || segments[^1].End != from.Place))
            {
                yield return new PlotStroke(segments, false, null) { Heat = heat };
                segments = [];
            }

            heat = step;
            segments.Add(Segment.FromLine(from.Place, to.Place));
        }

        if (segments.Count > 0) yield return new PlotStroke(segments, false, null) { Heat = heat };
    }
}
