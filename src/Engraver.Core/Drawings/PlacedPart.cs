using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Transforms a part by a placement: a line remains a line, an arc remains one or becomes an ellipse, ellipses and splines keep their kind.</summary>
public static class PlacedPart
{
    /// <summary>Slope below which a tilted circle counts as level: its plan is then an ellipse whose axes differ by less than 1e-12 of the radius.</summary>
    private const double FlatSlope = 1e-6;

    /// <param name="part">The part; an ellipse or spline refers to <paramref name="curves"/>.</param>
    /// <param name="curves">Side column of the part.</param>
    /// <param name="placement">The map to apply.</param>
    /// <param name="placedCurves">Receives the curve when the placed part is an ellipse or spline, which then refers to it.</param>
    /// <param name="placed">The transformed part.</param>
    /// <returns>Out of range: <paramref name="placed"/> is not usable.</returns>
    public static PlacementOutcome Try(in DrawingPart part, IReadOnlyList<RationalCurve> curves, in Placement placement, List<RationalCurve> placedCurves, out DrawingPart placed)
    {
        ArgumentNullException.ThrowIfNull(curves);
        ArgumentNullException.ThrowIfNull(placedCurves);
        if (part.Kind == SegmentKind.Line) return TryLine(part, placement, out placed);
        return part.IsFreeCurve ? TryCurve(part, curves[part.CurveIndex], placement, placedCurves, out placed) : TryArc(part, placement, placedCurves, out placed);
    }

    private static PlacementOutcome TryLine(in DrawingPart part, in Placement placement, out DrawingPart placed)
    {
        var start = placement.Apply(new Vector3D(part.A, part.B, part.C));
        var end = placement.Apply(new Vector3D(part.D, part.E, part.F));
        placed = DrawingPart.Line(part.Entity, start.X, start.Y, start.Z, end.X, end.Y, end.Z);
        return InRange(start) && InRange(end) ? PlacementOutcome.Exact : PlacementOutcome.OutOfRange;
    }

    /// <summary>An arc remains an arc when the x and y axes remain level, perpendicular and equally long; a mirror reverses its direction.</summary>
    private static PlacementOutcome TryArc(in DrawingPart part, in Placement placement, List<RationalCurve> placedCurves, out DrawingPart placed)
    {
        placed = part;
        var ellipse = new EllipseArc(
            placement.Apply(new Vector3D(part.A, part.B, part.C)), placement.XAxis * part.D, placement.YAxis * part.D, Angle.FromDegrees(part.E), Angle.FromDegrees(part.F));
        if (!InRange(ellipse.Centre) || !InRange(ellipse.First) || !InRange(ellipse.Second)) return PlacementOutcome.OutOfRange;
        var unit = ellipse with { First = placement.XAxis, Second = placement.YAxis };
        if (unit.IsCircular)
        {
            var arc = unit.ToArc();
            placed = DrawingPart.Arc(part.Entity, arc with { Radius = part.D * arc.Radius }, ellipse.Centre.Z);
            return PlacementOutcome.Exact;
        }

        placedCurves.Add(ellipse.ToCurve());
        placed = DrawingPart.FreeCurve(part.Entity, SegmentKind.Ellipse, placedCurves.Count - 1);
        return IsLevel(placement) ? PlacementOutcome.Exact : PlacementOutcome.Tilted;
    }

    private static PlacementOutcome TryCurve(in DrawingPart part, RationalCurve curve, in Placement placement, List<RationalCurve> placedCurves, out DrawingPart placed)
    {
        placed = DrawingPart.FreeCurve(part.Entity, part.Kind, placedCurves.Count);
        var spans = new BezierSpan[curve.Spans.Length];
        for (var i = 0; i < spans.Length; i++)
        {
            spans[i] = Placed(curve.Spans[i], placement);
            if (!InRange(spans[i])) return PlacementOutcome.OutOfRange;
        }

        placedCurves.Add(curve.With(spans));
        return IsLevel(placement) ? PlacementOutcome.Exact : PlacementOutcome.Tilted;
    }

    /// <summary>Applies an affine map to homogeneous points: displacements are multiplied by the weight.</summary>
    private static BezierSpan Placed(BezierSpan span, in Placement placement)
    {
        var points = span.Homogeneous.ToArray();
        for (var i = 0; i < points.Length; i += BezierSpan.Stride)
        {
            var place = placement.ApplyToDirection(new Vector3D(points[i], points[i + 1], points[i + 2])) + (placement.Origin * points[i + 3]);
            (points[i], points[i + 1], points[i + 2]) = (place.X, place.Y, place.Z);
        }

        return new BezierSpan(points);
    }

    private static bool IsLevel(in Placement placement) =>
        Math.Abs(placement.XAxis.Z) <= FlatSlope * placement.XAxis.Length && Math.Abs(placement.YAxis.Z) <= FlatSlope * placement.YAxis.Length;

    /// <summary>True when every number of the curve is usable in a drawing.</summary>
    public static bool InRange(RationalCurve curve)
    {
        ArgumentNullException.ThrowIfNull(curve);
        foreach (var span in curve.Spans)
        {
            if (!InRange(span)) return false;
        }

        return true;
    }

    /// <summary>True for a point that is not above the largest coordinate.</summary>
    public static bool InRange(Vector3D point) =>
        Math.Abs(point.X) <= Drawing.LargestCoordinate && Math.Abs(point.Y) <= Drawing.LargestCoordinate && Math.Abs(point.Z) <= Drawing.LargestCoordinate;

    private static bool InRange(BezierSpan span)
    {
        foreach (var value in span.Homogeneous)
        {
            if (!(Math.Abs(value) <= Drawing.LargestCoordinate)) return false;
        }

        return true;
    }
}
