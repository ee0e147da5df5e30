using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Verification;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Tells the judges where the tool goes. The time is only an order.</summary>
internal sealed class TrajectoryTeller(ReplayRequest request)
{
    /// <summary>A chord of a cubic leaves it by no more, millimetres.</summary>
    private const double ChordError = 1e-5;

    private const int MostHalvings = 10;

    private readonly IReadOnlyList<ITraceJudge> _judges = request.Judges;
    private Point2D _place;
    private double _seconds;

    /// <summary>What is asked of the program.</summary>
    public ReplayRequest Request => request;

    /// <summary>With the tool off.</summary>
    public void GoTo(Point2D place)
    {
        _place = place;
        foreach (var judge in _judges) judge.Add(new TraceSample(_seconds += 1.0, place.X, place.Y, Cutting: false));
    }

    public void LineTo(Point2D place)
    {
        if (place != _place) Tell(Segment.FromLine(_place, place));
    }

    public void ArcTo(ArcSegment arc) => Tell(Segment.FromArc(arc));

    /// <summary>Along a cubic, by its control points as Bezier has them: it lies in the hull of its ends and of both. Where both lie on the chord it is the chord, however the speed changes along it.</summary>
    public void CurveTo(Point2D leaving, Point2D arriving, Point2D end) => CurveTo(leaving, arriving, end, MostHalvings);

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

    private void Tell(in Segment path)
    {
        foreach (var judge in _judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
        (_place, _seconds) = (path.End, _seconds + 1.0);
    }
}
