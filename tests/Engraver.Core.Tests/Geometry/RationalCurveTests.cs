using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

/// <summary>Curves whose lengths and points are known by other means.</summary>
public class RationalCurveTests
{
    [Theory]
    [InlineData(1.0, 6.283185307179586)]
    [InlineData(0.5, 4.844224110273838)] // 4 E(sqrt(3)/2)
    [InlineData(0.1, 4.063974180100896)]
    [InlineData(0.0, 4.0)] // a line forwards and back
    public void The_perimeter_of_an_ellipse_is_the_elliptic_integral(double ratio, double perimeter)
    {
        var curve = FreeCurves.Ellipse(3.0, -2.0, 1.0, ratio, 30.0, 0.0, 360.0).ToCurve();

        Assert.Equal(perimeter, curve.PlanLength, 1e-9 * perimeter);
        Assert.True(curve.IsClosed);
    }

    [Fact]
    public void A_circle_as_a_rational_spline_is_a_circle_everywhere()
    {
        var curve = Circle();

        Assert.Equal(20.0 * Math.PI, curve.PlanLength, 1e-9);
        for (var i = 0; i <= 1000; i++) Assert.Equal(10.0, curve.PointAt(i / 1000.0).DistanceTo(default), 1e-12);
        Assert.True(curve.IsClosed);
        Assert.True(Near(new Bounds2D(-10, -10, 10, 10), curve.Bounds, 1e-11));
    }

    [Fact]
    public void A_quadratic_spline_of_three_points_is_a_parabola()
    {
        var curve = FreeCurves.Spline(2, [new(0, 0), new(1, 2), new(2, 0)], [1, 1, 1]); // y = x (2 - x)

        Assert.Equal(Math.Sqrt(5.0) + (Math.Asinh(2.0) / 2.0), curve.PlanLength, 1e-9);
        Assert.True(Near(new Bounds2D(0, 0, 2, 1), curve.Bounds, 1e-12));
        Assert.Equal(0.75, curve.PointAt(0.25).Y, 1e-15);
    }

    [Fact]
    public void The_domain_of_an_unclamped_spline_lies_between_its_inner_knots()
    {
        Point2D[] ring = [new(10, 0), new(5, 9), new(-5, 9), new(-10, 0), new(-5, -9), new(5, -9), new(10, 0), new(5, 9), new(-5, 9)];
        double[] knots = [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
        var curve = FreeCurves.Spline(3, knots, ring, [1, 1, 1, 1, 1, 1, 1, 1, 1]);

        Assert.Equal(6, curve.Spans.Length);
        Assert.True(curve.IsClosed);
        Assert.True(curve.Start.IsNear(new Point2D((10 + (4 * 5) - 5) / 6.0, (0 + (4 * 9) + 9) / 6.0), 1e-12));
    }

    [Fact]
    public void A_spline_through_fit_points_passes_them_and_has_no_corner()
    {
        Vector3D[] points = [new(0, 0, 0), new(10, 5, 0), new(20, 0, 0), new(30, 5, 0)];
        foreach (var closed in new[] { false, true })
        {
            var curve = FitPointSpline.Through(points, null, null, closed);
            for (var i = 0; i < curve.Spans.Length; i++)
            {
                Assert.True(curve.Spans[i].Start.IsNear(new Point2D(points[i].X, points[i].Y), 1e-12));
                if (i > 0 || closed) Assert.Equal(0.0, Curvature(curve.Spans[(i + curve.Spans.Length - 1) % curve.Spans.Length].Reversed()) + Curvature(curve.Spans[i]), 1e-9);
            }
        }
    }

    [Fact]
    public void Given_end_tangents_are_met()
    {
        var curve = FitPointSpline.Through([new(0, 0, 0), new(10, 0, 0)], new Vector3D(0, 3, 0), new Vector3D(0, -3, 0), closed: false);

        Assert.Equal((0.0, 1.0), (curve.StartTangent.X, curve.StartTangent.Y));
        Assert.Equal((0.0, -1.0), (curve.EndTangent.X, curve.EndTangent.Y));
    }

    [Property]
    public Property Boxes_hold_every_place_and_touch_the_curve() => Prop.ForAll(FreeCurves.Splines, curve =>
    {
        var box = Bounds2D.Empty;
        for (var i = 0; i <= 4000; i++) box = box.Including(curve.PointAt(i / 4000.0));
        return curve.Bounds.Grown(1e-10).Contains(box) && box.Grown(1e-3).Contains(curve.Bounds);
    });

    [Property]
    public Property Reversing_twice_is_the_identity_and_once_keeps_every_place() => Prop.ForAll(FreeCurves.Splines, curve =>
    {
        var (turned, again) = (curve.Reversed(), curve.Reversed().Reversed());
        return turned.Start == curve.End && turned.PointAt(0.3).IsNear(curve.PointAt(0.7), 1e-10) && again.PointAt(0.3) == curve.PointAt(0.3) && again.Spans.Length == curve.Spans.Length;
    });

    [Property]
    public Property The_distance_to_a_place_beside_the_curve_is_how_far_it_lies_beside() => Prop.ForAll(FreeCurves.Ellipses, curve =>
    {
        var along = curve.TangentAt(0.37);
        var beside = curve.PointAt(0.37) + (new Vector2D(-along.Y, along.X) * 1e-4);
        return Math.Abs(curve.DistanceTo(beside) - 1e-4) < 1e-7 && curve.DistanceTo(curve.PointAt(0.37)) < 1e-9;
    });

    /// <summary>Nine points of degree 2, as CAD programs write a circle of radius 10.</summary>
    internal static RationalCurve Circle()
    {
        var w = Math.Sqrt(0.5);
        Point2D[] points = [new(10, 0), new(10, 10), new(0, 10), new(-10, 10), new(-10, 0), new(-10, -10), new(0, -10), new(10, -10), new(10, 0)];
        return FreeCurves.Spline(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], points, [1, w, 1, w, 1, w, 1, w, 1]);
    }

    private static bool Near(Bounds2D expected, Bounds2D actual, double within) => actual.Grown(within).Contains(expected) && expected.Grown(within).Contains(actual);

    /// <summary>Signed, at the start.</summary>
    private static double Curvature(BezierSpan span)
    {
        var (first, second) = (span.Control(1) - span.Control(0), span.Control(2) - span.Control(1));
        return 2.0 / 3.0 * first.Cross(second) / (first.LengthSquared * first.Length);
    }
}
