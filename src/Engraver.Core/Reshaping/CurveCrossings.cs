using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Crossings of an ellipse or spline with an unlimited line or a full circle: points where its signed distance from it changes sign
/// (<see cref="CurveRoots"/>).</summary>
public static class CurveCrossings
{
    /// <returns>Fractions of the curve's parameter, ascending.</returns>
    public static IEnumerable<double> Find(RationalCurve curve, Segment carrier)
    {
        ArgumentNullException.ThrowIfNull(curve);
        return carrier.IsFreeCurve ? [] : CurveRoots.Find(curve.Spans.Length, fraction => SideOf(carrier, curve.PointAt(fraction)));
    }

    /// <summary>Distance from the line, left positive, or from the circle, outside positive.</summary>
    private static double SideOf(Segment carrier, Point2D place) => carrier.Kind == SegmentKind.Line
        ? (carrier.End - carrier.Start).Cross(place - carrier.Start)
        : place.DistanceTo(carrier.Arc.Centre) - carrier.Arc.Radius;
}
