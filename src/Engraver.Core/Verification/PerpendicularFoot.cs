using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The point of a segment nearest to another point (its foot), as a fraction of the segment (see <see cref="Segment.PointAt"/>).</summary>
internal static class PerpendicularFoot
{
    private const int MaxSteps = 60;
    private const double ParameterKnown = 1e-12;

    /// <summary>A guess nearer to an end than this is not used: the derivative can be zero there, and Newton's step would not converge.</summary>
    private const double NearEnd = 1e-4;

    /// <param name="segment">A line, an arc, a circle or a nearly straight piece of a curve.</param>
    /// <param name="guess">Start of the search on a curve; NaN when unknown.</param>
    public static (double Foot, double Distance) Place(in Segment segment, Point2D place, double guess)
    {
        if (segment.IsFreeCurve)
        {
            var foot = Place(segment.Curve.Spans[0], place, guess);
            return (foot, segment.Curve.Spans[0].PointAt(foot).DistanceTo(place));
        }

        return segment.Kind == SegmentKind.Line ? Place(segment.Line, place) : Place(segment.Arc, place);
    }

    /// <summary>Newton's steps, kept between two parameters on either side of the foot.</summary>
    public static double Place(BezierSpan span, Point2D place, double guess = double.NaN)
    {
        var (low, high) = (0.0, 1.0);
        var parameter = guess is > NearEnd and < 1.0 - NearEnd ? guess : OfChord(span, place);
        for (var step = 0; step < MaxSteps && high - low > ParameterKnown; step++)
        {
            var point = span.Evaluate(parameter, out var derivative);
            var ahead = (place - point).Dot(derivative.LengthSquared > 0.0 ? derivative : span.TangentAt(parameter)); // a zero derivative gives no direction
            if (ahead > 0.0) low = parameter;
            else high = parameter;
            var next = parameter + (ahead / derivative.LengthSquared);
            if (!(next > low && next < high)) next = (low + high) / 2.0;
            if (Math.Abs(next - parameter) <= ParameterKnown) return next;
            parameter = next;
        }

        return parameter;
    }

    private static double OfChord(BezierSpan span, Point2D place)
    {
        var chord = span.End - span.Start;
        return chord.LengthSquared == 0.0 ? 0.5 : Math.Clamp((place - span.Start).Dot(chord) / chord.LengthSquared, 0.0, 1.0);
    }

    private static (double Foot, double Distance) Place(LineSegment line, Point2D place)
    {
        var (way, spoke) = (line.End - line.Start, place - line.Start);
        var squared = way.LengthSquared;
        var foot = squared == 0.0 ? 0.0 : Math.Clamp(spoke.Dot(way) / squared, 0.0, 1.0);
        return (foot, Math.Sqrt((spoke - (way * foot)).LengthSquared));
    }

    private static (double Foot, double Distance) Place(ArcSegment arc, Point2D place)
    {
        var spoke = place - arc.Centre;
        var (radius, sweep) = (Math.Sqrt(spoke.LengthSquared), arc.Sweep.Radians);
        var ahead = Math.IEEERemainder(Math.Atan2(spoke.Y, spoke.X) - arc.Start.Radians, 2.0 * Math.PI) * Math.Sign(sweep);
        if (ahead < 0.0) ahead += 2.0 * Math.PI;
        if (ahead <= Math.Abs(sweep)) return (ahead / Math.Abs(sweep), Math.Abs(radius - arc.Radius));
        var (toStart, toEnd) = (arc.StartPoint.DistanceTo(place), arc.EndPoint.DistanceTo(place));
        return toStart <= toEnd ? (0.0, toStart) : (1.0, toEnd);
    }
}
