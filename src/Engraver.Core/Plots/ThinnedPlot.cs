using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>The lines of a picture that has more of them than a page can hold, drawn at the finest resolution at which they fit: one path for each
/// colour.</summary>
internal sealed class ThinnedPlot
{
    /// <summary>Finest resolution, picture units: half of the resolution of a printed picture 1200 units wide.</summary>
    private const double Finest = 0.5;

    private readonly SortedDictionary<int, (string Colour, PlotInk Ink)> _strokes = [];
    private readonly PlotInk _rapids;
    private readonly PlotFrame _frame;

    private ThinnedPlot(PlotFrame frame, double cell) => (_frame, Cell, _rapids) = (frame, cell, new PlotInk(frame.FieldWidth, frame.FieldHeight, cell));

    /// <summary>The resolution, picture units.</summary>
    public double Cell { get; }

    /// <summary>The path of all travel; empty without any.</summary>
    public string Rapids => _rapids.ToString();

    /// <summary>The class and the path of each colour, from the lowest to the topmost: of a run's measure the largest.</summary>
    public IEnumerable<(string Colour, string Path)> Strokes => _strokes.Values.Select(one => (one.Colour, one.Ink.ToString()));

    /// <summary>Approximate number of characters of the picture with every line: a curve with its class, its lines, its arcs in two halves, its ellipses and
    /// splines as several arcs.</summary>
    public static long WholeLength(PlotModel plot) =>
        (plot.Rapids.Count * 36L) + plot.Strokes.Sum(stroke => 45L + stroke.Segments.Sum(segment => segment.Kind == SegmentKind.Line ? 17L : segment.IsFreeCurve ? 360L : 90L));

    /// <summary>Tries increasingly coarse resolutions: each line inks its own cell, and each step has four times fewer cells.</summary>
    /// <param name="most">Maximum number of characters of all paths together.</param>
    /// <param name="colour">The class of a curve.</param>
    public static ThinnedPlot Of(PlotModel plot, PlotFrame frame, int most, Func<PlotStroke, string> colour)
    {
        for (var cell = Finest; ; cell *= 2.0)
        {
            var thinned = new ThinnedPlot(frame, cell);
            if (thinned.Draw(plot, most, colour)) return thinned;
        }
    }

    /// <returns>False when this is too many.</returns>
    private bool Draw(PlotModel plot, int most, Func<PlotStroke, string> colour)
    {
        foreach (var rapid in plot.Rapids) _rapids.Add([_frame.Place(rapid.Start), _frame.Place(rapid.End)]);
        foreach (var stroke in plot.Strokes)
        {
            InkOf(stroke.Heat ?? (stroke.Closed ? 0 : 1), colour(stroke)).Add(Places(stroke.Segments));
            if (_rapids.Length + _strokes.Values.Sum(one => one.Ink.Length) > most) return false;
        }

        return true;
    }

    private PlotInk InkOf(int level, string colour)
    {
        if (!_strokes.TryGetValue(level, out var found)) _strokes.Add(level, found = (colour, new PlotInk(_frame.FieldWidth, _frame.FieldHeight, Cell)));
        return found.Ink;
    }

    /// <summary>The ends of segments that are joined, and between those of an arc as many points as needed for all chords to stay within a quarter of the
    /// resolution of it.</summary>
    private IEnumerable<Point2D> Places(IReadOnlyList<Segment> segments)
    {
        yield return _frame.Place(segments[0].Start);
        foreach (var segment in segments.SelectMany(one => SvgPath.Drawable(one, _frame)))
        {
            var chords = segment.Kind == SegmentKind.Line ? 1 : Chords(segment.Arc);
            for (var i = 1; i <= chords; i++) yield return _frame.Place(i == chords ? segment.End : segment.PointAt((double)i / chords));
        }
    }

    private int Chords(in ArcSegment arc)
    {
        var flat = Math.Min(1.0, Cell / 4.0 / (arc.Radius * _frame.Scale));
        return Math.Max(1, (int)Math.Ceiling(Math.Abs(arc.Sweep.Radians) / (2.0 * Math.Acos(1.0 - flat))));
    }
}
