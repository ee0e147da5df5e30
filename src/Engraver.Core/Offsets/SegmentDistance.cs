using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>Distance of a point from a segment.</summary>
public static class SegmentDistance
{
    /// <summary>The distance in the unit of the coordinates; an ellipse or spline is measured as the curve itself.</summary>
    public static double Measure(in Segment segment, Point2D place)
    {
        if (segment.IsFreeCurve) return segment.Curve.DistanceTo(place);
        if (segment.Kind == SegmentKind.Line)
        {
            var (way, from) = (segment.End - segment.Start, place - segment.Start);
            return way.LengthSquared == 0.0 ? from.Length : (from - (way * Math.Clamp(from.Dot(way) / way.LengthSquared, 0.0, 1.0))).Length;
        }

        var arc = segment.Arc;
        var spoke = place - arc.Centre;
        var ahead = arc.Sweep.Degrees >= 0.0 ? (spoke.Direction - arc.Start).Positive().Degrees : (arc.Start - spoke.Direction).Positive().Degrees;
        return ahead <= Math.Abs(arc.Sweep.Degrees) ? Math.Abs(spoke.Length - arc.Radius) : Math.Min(place.DistanceTo(segment.Start), place.DistanceTo(segment.End));
    }
}
