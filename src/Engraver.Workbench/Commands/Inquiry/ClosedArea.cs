using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>The area enclosed by connected segments; an open run is closed by a straight line, as in AutoCAD.</summary>
internal static class ClosedArea
{
    /// <summary>Number of chords that approximate an ellipse or a spline.</summary>
    private const int CurveSteps = 4096;

    /// <returns>Never negative; a self-intersecting outline counts each part by its winding number.</returns>
    public static double Measure(IReadOnlyList<Segment> segments)
    {
        if (segments.Count == 0) return 0.0;
        var twice = Chord(segments[^1].End, segments[0].Start, segments[0].Start);
        foreach (var segment in segments) twice += Under(segment, segments[0].Start);
        return Math.Abs(twice) / 2.0;
    }

    /// <summary>Twice the signed area between a segment and a fixed point.</summary>
    private static double Under(in Segment segment, Point2D about)
    {
        if (segment.IsFreeCurve) return Stepped(segment, about);
        var straight = Chord(segment.Start, segment.End, about);
        if (segment.Kind == SegmentKind.Line) return straight;
        var (radius, sweep) = (segment.Arc.Radius, segment.Arc.Sweep);
        return straight + (radius * radius * (sweep.Radians - sweep.Sin()));
    }

    private static double Chord(Point2D from, Point2D to, Point2D about) => (from - about).Cross(to - about);

    private static double Stepped(in Segment segment, Point2D about)
    {
        var (twice, from) = (0.0, segment.Start);
        for (var step = 1; step <= CurveSteps; step++)
        {
            var to = segment.PointAt((double)step / CurveSteps);
            twice += Chord(from, to, about);
            from = to;
        }

        return twice;
    }
}
