using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes an ellipse or spline exactly: ELLIPSE with its axes and parameters, SPLINE with its Bezier points and knots of full multiplicity. Heights
/// are kept and the direction is read back; an ellipse that is not level, or whose axes were lost in rounding, is written as its SPLINE.</summary>
internal static class DxfCurveWriter
{
    private const int Planar = 8;
    private const int Rational = 4;
    private const int Closed = 1;

    /// <summary>Heights that differ by less, as a part of the size, differ only by rounding.</summary>
    private const double LevelTo = 1e-12;

    /// <summary>Writes the pairs after the common pairs of the entity.</summary>
    public static void Write(DxfTagWriter tags, RationalCurve curve)
    {
        if (PlanOf(curve) is { } ellipse) Ellipse(tags, ellipse, curve.Spans[0].Z(0));
        else Spline(tags, curve);
    }

    /// <summary>True when the curve is written as an ELLIPSE.</summary>
    public static bool IsEllipse(RationalCurve curve) => PlanOf(curve) is not null;

    private static EllipsePlan? PlanOf(RationalCurve curve) => curve.Kind == SegmentKind.Ellipse && IsLevel(curve) ? EllipsePlan.From(curve) : null;

    private static bool IsLevel(RationalCurve curve)
    {
        var z = curve.Spans[0].Z(0);
        foreach (var span in curve.Spans)
        {
            for (var i = 0; i <= span.Degree; i++)
            {
                if (Math.Abs(span.Z(i) - z) > LevelTo * Math.Max(1.0, Math.Abs(z))) return false;
            }
        }

        return true;
    }

    /// <summary>An ELLIPSE always runs counter-clockwise about its extrusion, so a clockwise one is written with 0,0,-1. Its points are in world
    /// coordinates.</summary>
    private static void Ellipse(DxfTagWriter tags, EllipsePlan ellipse, double z)
    {
        tags.Class("AcDbEllipse").Point(10, ellipse.Centre, z).Point(11, Point2D.Origin + ellipse.Major);
        tags.Real(210, 0.0).Real(220, 0.0).Real(230, ellipse.CounterClockwise ? 1.0 : -1.0);
        tags.Real(40, ellipse.Ratio).Real(41, ellipse.Start).Real(42, ellipse.End);
    }

    private static void Spline(DxfTagWriter tags, RationalCurve curve)
    {
        var degree = curve.Spans[0].Degree;
        var points = Points(curve);
        var knots = Knots(curve.Spans.Length, degree);
        var rational = points.Exists(point => point.Weight != 1.0);
        tags.Class("AcDbSpline").Real(210, 0.0).Real(220, 0.0).Real(230, 1.0);
        tags.Integer(70, (IsLevel(curve) ? Planar : 0) | (rational ? Rational : 0) | (curve.IsClosed ? Closed : 0)).Integer(71, degree).Integer(72, knots.Count).Integer(73, points.Count).Integer(74, 0);
        foreach (var knot in knots) tags.Real(40, knot);
        foreach (var point in points)
        {
            if (rational) tags.Real(41, point.Weight);
        }

        foreach (var point in points) tags.Point(10, point.Place, point.Z);
    }

    /// <summary>Control points of all spans (of one degree), shared ones once. Weights of a span may be scaled by a common factor, so that neighbours agree in
    /// their shared point.</summary>
    private static List<(Point2D Place, double Z, double Weight)> Points(RationalCurve curve)
    {
        var points = new List<(Point2D Place, double Z, double Weight)>();
        foreach (var span in curve.Spans)
        {
            var factor = points.Count == 0 ? 1.0 : points[^1].Weight / span.Weight(0);
            for (var i = points.Count == 0 ? 0 : 1; i <= span.Degree; i++) points.Add((span.Control(i), span.Z(i), span.Weight(i) * factor));
        }

        return points;
    }

    private static List<double> Knots(int spans, int degree)
    {
        var knots = new List<double> { 0.0 };
        for (var knot = 0; knot <= spans; knot++) knots.AddRange(Enumerable.Repeat((double)knot, degree));
        knots.Add(spans);
        return knots;
    }
}
