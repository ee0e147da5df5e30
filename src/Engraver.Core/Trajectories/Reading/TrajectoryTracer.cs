using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Verification;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Passes the tool path to the judges. The time only gives the order.</summary>
internal sealed class TrajectoryTracer(ReplayRequest request)
{
    /// <summary>Largest distance of a chord from its cubic, millimetres.</summary>
    private const double ChordError = 1e-5;

    private const int MaxHalvings = 10;

    private readonly IReadOnlyList<ITraceJudge> _judges = request.Judges;
    private Point2D _place;
    private double _seconds;

    /// <summary>The requirements for the program.</summary>
    public ReplayRequest Request => request;

    /// <summary>Moves with the tool off.</summary>
    public void GoTo(Point2D place)
    {
        _place = place;
        foreach (var judge in _judges) judge.Add(new TraceSample(_seconds += 1.0, place.X, place.Y, Cutting: false));
    }

    public void LineTo(Point2D place)
    {
        if (place != _place) AddSpan(Segment.FromLine(_place, place));
    }

    public void ArcTo(ArcSegment arc) => AddSpan(Segment.FromArc(arc));

    /// <summary>Moves along a cubic, given by its Bezier control points: it is in the hull of its ends and both control points. When both control points are on
    /// the chord, it is the chord, independent of the speed along it.</summary>
    public void CurveTo(Point2D leaving, Point2D arriving, Point2D end) => CurveTo(leaving, arriving, end, MaxHalvings);

    private void CurveTo(Point2D leaving, Point2D arriving, Point2D end, int halvings)
    {
        var chord = new LineSegment(_place, end);
        if (halvings == 0 || (chord.DistanceTo(leaving) <= ChordError && chord.DistanceTo(arriving) <= ChordError))
        {
            LineTo(end);
            return;
        }

        var (first, middle, last) = (Middle(_place, leaving), Middle(leaving, arriving), Middle(arriving, end));
        var (before, behind) = (Middle(first, middle), Middle(middle, last));
        CurveTo(first, before, Middle(before, behind), halvings - 1);
        CurveTo(behind, last, end, halvings - 1);
    }

    private static Point2D Middle(Point2D one, Point2D other) => new((one.X + other.X) / 2.0, (one.Y + other.Y) / 2.0);

    private void AddSpan(in Segment path)
    {
        foreach (var judge in _judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
        (_place, _seconds) = (path.End, _seconds + 1.0);
    }
}
