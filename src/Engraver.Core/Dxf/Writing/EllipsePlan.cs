using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>An ellipse or its arc in plan with the values that DXF stores, computed from its rational parabolas.</summary>
/// <param name="Major">From the centre to an end of the longer axis.</param>
/// <param name="Ratio">Shorter over longer axis, above 0 and at most 1.</param>
/// <param name="Start">Parameter at the start, radians, 0 to a turn.</param>
/// <param name="End">Parameter at the end, above the start.</param>
internal readonly record struct EllipsePlan(Point2D Centre, Vector2D Major, double Ratio, double Start, double End, bool CounterClockwise)
{
    /// <summary>Smallest ratio that AutoCAD accepts.</summary>
    private const double SmallestRatio = 1e-6;

    /// <summary>Maximum rounding of a start at 0, radians: a start just below 0 that would be written as a whole turn.</summary>
    private const double Rounding = 1e-13;

    /// <summary>Largest distance of a point of the written ellipse from the curve, as a part of its size and place.</summary>
    private const double Faithful = 1e-10;

    /// <summary>The ellipse of a curve; null where, because of rounding, none runs through the same points, as for an arc of a millionth of a turn.</summary>
    public static EllipsePlan? From(RationalCurve curve)
    {
        var plan = Fit(curve);
        var size = plan.Major.Length + Math.Abs(plan.Centre.X) + Math.Abs(plan.Centre.Y);
        var (first, last) = (curve.Spans[0], curve.Spans[^1]);
        var middle = curve.Spans.Length == 1 ? first.PointAt(0.5) : first.End;
        var share = curve.Spans.Length == 1 ? 0.5 : HalfAngle(first) / curve.Spans.ToArray().Sum(HalfAngle);
        var isFaithful = plan.IsNear(0.0, first.Start, Faithful * size) && plan.IsNear(share, middle, Faithful * size) && plan.IsNear(1.0, last.End, Faithful * size);
        return isFaithful ? plan : null; // comparisons with NaN are false
    }

    private bool IsNear(double share, Point2D place, double distance)
    {
        var (sin, cos) = Math.SinCos(Start + (share * (End - Start)));
        var minor = new Vector2D(-Major.Y, Major.X) * (CounterClockwise ? Ratio : -Ratio);
        return (Centre + (Major * cos) + (minor * sin)).DistanceTo(place) <= distance;
    }

    private static EllipsePlan Fit(RationalCurve curve)
    {
        var (centre, first, second, half) = Halves(curve.Spans[0]);
        var turn = 0.5 * Math.Atan2(2.0 * first.Dot(second), first.LengthSquared - second.LengthSquared);
        var (major, minor) = ((first * Math.Cos(turn)) + (second * Math.Sin(turn)), (second * Math.Cos(turn)) - (first * Math.Sin(turn)));
        if (minor.LengthSquared > major.LengthSquared) (major, minor, turn) = (minor, -major, turn + (Math.PI / 2.0));
        var sweep = curve.Spans.ToArray().Sum(span => 2.0 * HalfAngle(span));
        var start = Math.IEEERemainder(-half - turn, Math.Tau);
        if (start < 0.0) start = start > -Rounding ? 0.0 : start + Math.Tau;
        var ratio = Math.Max(minor.Length / major.Length, SmallestRatio);
        return new EllipsePlan(centre, major, ratio, start, start + (curve.IsClosed ? Math.Tau : sweep), major.Cross(minor) >= 0.0);
    }

    private static double HalfAngle(BezierSpan span) => Math.Acos(Math.Clamp(span.Weight(1) / Math.Sqrt(span.Weight(0) * span.Weight(2)), -1.0, 1.0));

    /// <summary>The conjugate half-diameters of a span over the parameters -half to half: centre + first cos + second sin.</summary>
    private static (Point2D Centre, Vector2D First, Vector2D Second, double Half) Halves(BezierSpan span)
    {
        var half = HalfAngle(span);
        var (cos, sin) = (Math.Cos(half), Math.Sin(half));
        var chord = span.End - span.Start;
        var middle = span.Start + (chord * 0.5);
        var first = (span.Control(1) - middle) * (cos / (sin * sin));
        return (middle - (first * cos), first, chord * (0.5 / sin), half);
    }
}
