using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace Engraver.TestKit;

/// <summary>Ellipses and splines for properties.</summary>
public static class FreeCurves
{
    private static readonly Gen<double> Coordinate = Gen.Choose(-50_000, 50_000).Select(micrometres => micrometres / 1000.0);

    private static readonly Gen<RationalCurve> EllipseArcs =
        from x in Coordinate
        from y in Coordinate
        from size in Gen.Choose(100, 50_000)
        from ratio in Gen.Choose(20, 1500)
        from turn in Gen.Choose(0, 359)
        from start in Gen.Choose(0, 359)
        from sweep in Gen.Frequency((3, Gen.Choose(1, 359)), (1, Gen.Constant(360)))
        from sign in Gen.Elements(1, -1)
        select Ellipse(x, y, size / 1000.0, ratio / 1000.0, turn, start, sign * sweep).ToCurve();

    private static readonly Gen<RationalCurve> SplineCurves =
        from degree in Gen.Choose(2, 5)
        from count in Gen.Choose(degree + 1, 12)
        from x in Coordinate.ArrayOf(count)
        from y in Coordinate.ArrayOf(count)
        from weight in Gen.Choose(3, 30).ArrayOf(count)
        select Spline(degree, [.. x.Zip(y, (a, b) => new Point2D(a, b))], [.. weight.Select(tenths => tenths / 10.0)]);

    /// <summary>Whole ellipses and arcs of them, including thin ones, in either direction.</summary>
    public static Arbitrary<RationalCurve> Ellipses { get; } = EllipseArcs.ToArbitrary();

    /// <summary>Rational splines of degree 2 to 5 through random places: loops, sharp bends, near cusps.</summary>
    public static Arbitrary<RationalCurve> Splines { get; } = SplineCurves.ToArbitrary();

    public static EllipseArc Ellipse(double x, double y, double major, double ratio, double turnDegrees, double startDegrees, double sweepDegrees)
    {
        var turn = Angle.FromDegrees(turnDegrees);
        return new EllipseArc(
            new Vector3D(x, y, 0.0),
            new Vector3D(major * turn.Cos(), major * turn.Sin(), 0.0),
            new Vector3D(-major * ratio * turn.Sin(), major * ratio * turn.Cos(), 0.0),
            Angle.FromDegrees(startDegrees),
            Angle.FromDegrees(sweepDegrees));
    }

    /// <summary>A spline with uniform knots that starts and ends at its outer control points.</summary>
    public static RationalCurve Spline(int degree, Point2D[] controls, double[] weights) =>
        Spline(degree, NurbsCurve.UniformKnots(degree, controls.Length), controls, weights);

    public static RationalCurve Spline(int degree, double[] knots, Point2D[] controls, double[] weights)
    {
        double[] homogeneous = [.. controls.SelectMany((point, i) => new[] { point.X * weights[i], point.Y * weights[i], 0.0, weights[i] })];
        return new NurbsCurve(degree, knots, homogeneous).ToCurve()!;
    }
}
