using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Tells the judges where the tool goes. The time is only an order.</summary>
internal sealed class TrajectoryTeller(IReadOnlyList<ITraceJudge> judges)
{
    /// <summary>A chord of a cubic leaves it by no more, millimetres.</summary>
    private const double ChordError = 1e-6;

    private const int MostChords = 1024;

    private Point2D _place;
    private double _seconds;

    /// <summary>With the tool off.</summary>
    public void GoTo(Point2D place)
    {
        _place = place;
        foreach (var judge in judges) judge.Add(new TraceSample(_seconds += 1.0, place.X, place.Y, Cutting: false));
    }

    public void LineTo(Point2D place)
    {
        if (place != _place) Tell(Segment.FromLine(_place, place));
    }

    public void ArcTo(ArcSegment arc) => Tell(Segment.FromArc(arc));

    /// <summary>Along a cubic, in chords of equal steps of its parameter: at most the largest second derivative, which a cubic has at an end, over 8 and the square of their number lies between a chord and the curve.</summary>
    /// <param name="leaving">Second derivative at its start.</param>
    /// <param name="arriving">And at its end.</param>
    /// <param name="end">Of the cubic.</param>
    /// <param name="at">Its place by the parameter, 0 to 1.</param>
    public void CurveTo((double X, double Y) leaving, (double X, double Y) arriving, Point2D end, Func<double, Point2D> at)
    {
        var bend = Math.Max(double.Hypot(leaving.X, leaving.Y), double.Hypot(arriving.X, arriving.Y));
        var chords = (int)Math.Clamp(Math.Ceiling(Math.Sqrt(bend / (8.0 * ChordError))), 1.0, MostChords);
        for (var k = 1; k < chords; k++) LineTo(at((double)k / chords));
        LineTo(end);
    }

    private void Tell(in Segment path)
    {
        foreach (var judge in judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
        (_place, _seconds) = (path.End, _seconds + 1.0);
    }
}
