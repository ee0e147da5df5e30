using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry.Biarcs;

/// <summary>The replacement of a curve in the toolpath, measured by dense sampling that is independent of the bounds of the fit.</summary>
public class BiarcFitTests
{
    private const double MaxError = 0.001;
    private const int Samples = 1000;

    [Property]
    public Property Ellipses_stay_within_the_error() => Prop.ForAll(FreeCurves.Ellipses, StaysWithin);

    /// <summary>An ellipse of 6 mm at a distance at which neighbouring numbers are kilometres apart: no arc fits the rounded curve, and the search must not
    /// halve its step indefinitely.</summary>
    [Theory]
    [InlineData(1e15)]
    [InlineData(1e17)]
    [InlineData(99999999999999999999.0)]
    [InlineData(1e90)]
    public void A_curve_that_rounding_has_worn_away_comes_to_an_end(double distance)
    {
        var ellipse = new EllipseArc(new Vector3D(distance, 0, 0), new Vector3D(6, 2, 0), new Vector3D(-0.8, 2.4, 0), Angle.FromDegrees(17), Angle.FromDegrees(212));

        Assert.InRange(BiarcFit.Fit(ellipse.ToCurve(), 0.01).Count, 1, 1000);
    }

    [Property]
    public Property Splines_stay_within_the_error() => Prop.ForAll(FreeCurves.Splines, StaysWithin);

    [Property]
    public Property Every_place_of_the_arcs_is_as_near_to_the_curve() => Prop.ForAll(FreeCurves.Ellipses, ArcsAreNear);

    /// <summary>A span that leaves its chord only in a sharp bend at its end: Newton's method alone loses the foot.</summary>
    [Fact]
    public void The_distance_is_found_where_a_thin_ellipse_turns_sharply() => Assert.True(ArcsAreNear(FreeCurves.Ellipse(-29.957, 34.926, 36.792, 0.022, 262.0, 84.0, -242.0).ToCurve()));

    [Property]
    public Property Ends_and_end_tangents_are_the_curves_and_neighbours_share_theirs() => Prop.ForAll(FreeCurves.Ellipses, curve =>
    {
        var pieces = BiarcFit.Fit(curve, MaxError);
        var joined = pieces.Zip(pieces.Skip(1)).All(pair => pair.First.End == pair.Second.Start && Turn(pair.First.EndTangent, pair.Second.StartTangent) < 1e-4);
        return (joined && pieces[0].Start == curve.Start && pieces[^1].End == curve.End
            && Turn(curve.StartTangent, pieces[0].StartTangent) < 1e-4 && Turn(pieces[^1].EndTangent, curve.EndTangent) < 1e-4).Label($"{curve.Start} {curve.Bounds} {pieces.Count}");
    });

    [Fact]
    public void A_finer_error_takes_about_the_cube_root_more_pieces()
    {
        var curve = FreeCurves.Ellipse(0, 0, 20.0, 0.25, 0.0, 0.0, 360.0).ToCurve();

        Assert.InRange(BiarcFit.Fit(curve, 1e-3).Count, 40, 66);
        Assert.InRange(BiarcFit.Fit(curve, 1e-6).Count, 400, 660);
    }

    [Fact]
    public void A_circle_as_a_spline_is_cut_as_arcs_of_that_circle()
    {
        var pieces = BiarcFit.Fit(RationalCurveTests.Circle(), MaxError);

        Assert.InRange(pieces.Count, 1, 4);
        Assert.All(pieces, piece => Assert.Equal(10.0, piece.Arc.Radius, 1e-9));
        Assert.Equal(20.0 * Math.PI, pieces.Sum(piece => piece.Length), 1e-9);
    }

    /// <summary>CAD programs write and round a small circle in this way: three arcs, each longer than a span, without a corner between them.</summary>
    [Fact]
    public void A_circle_of_four_rounded_spans_is_cut_by_three_arcs_across_them()
    {
        Point2D[] points = [new(-33.5, -75.75), new(-32.8115, -75.75), new(-32.25, -76.3115), new(-32.25, -77.0), new(-32.25, -77.6884), new(-32.8115, -78.25), new(-33.5, -78.25), new(-34.1885, -78.25), new(-34.75, -77.6884), new(-34.75, -77.0), new(-34.75, -76.3115), new(-34.1885, -75.75), new(-33.5, -75.75)];
        var circle = FreeCurves.Spline(3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4], points, [.. points.Select(_ => 1.0)]);

        var pieces = BiarcFit.Fit(circle, 0.01);

        Assert.Equal(3, pieces.Count);
        Assert.All(pieces.Zip(pieces.Skip(1)), pair => Assert.True(Turn(pair.First.EndTangent, pair.Second.StartTangent) < 1e-9));
        Assert.True(StaysWithin(circle, pieces, 0.01));
        Assert.All(pieces, piece => Assert.True(Enumerable.Range(0, 101).All(i => circle.DistanceTo(piece.PointAt(i / 100.0)) <= 0.01)));
    }

    [Fact]
    public void A_straight_spline_is_one_line() =>
        Assert.Equal(SegmentKind.Line, Assert.Single(BiarcFit.Fit(FreeCurves.Spline(3, [new(0, 0), new(1, 1), new(5, 5), new(9, 9), new(10, 10)], [1, 1, 1, 1, 1]), MaxError)).Kind);

    [Fact]
    public void Corners_of_a_degree_1_spline_stay_corners() =>
        Assert.Equal(["10, 0", "10, 10"], BiarcFit.Fit(FreeCurves.Spline(1, [new(0, 0), new(10, 0), new(10, 10)], [1, 1, 1]), MaxError).Select(piece => $"{piece.End.X}, {piece.End.Y}"));

    [Fact]
    public void A_cusp_is_reached_and_left()
    {
        var cusp = FreeCurves.Spline(3, [new(0, 0), new(10, 10), new(0, 10), new(10, 0)], [1, 1, 1, 1]);

        Assert.True(StaysWithin(cusp));
    }

    [Fact]
    public void A_curve_of_astronomic_size_comes_to_an_end() =>
        Assert.InRange(BiarcFit.Fit(FreeCurves.Ellipse(0, 0, 1e90, 0.3, 10.0, 5.0, 300.0).ToCurve(), MaxError).Count, 1, 100_000);

    private static bool ArcsAreNear(RationalCurve curve) =>
        BiarcFit.Fit(curve, MaxError).All(piece => Enumerable.Range(0, 21).All(i => curve.DistanceTo(piece.PointAt(i / 20.0)) <= MaxError * 1.0001));

    private static bool StaysWithin(RationalCurve curve) => StaysWithin(curve, BiarcFit.Fit(curve, MaxError), MaxError);

    private static bool StaysWithin(RationalCurve curve, IReadOnlyList<Segment> pieces, double error)
    {
        var near = 0;
        for (var i = 0; i <= Samples; i++)
        {
            var place = curve.PointAt((double)i / Samples);
            while (near < pieces.Count && !(pieces[near].DistanceTo(place) <= error)) near++; // in order: the path follows the curve along its whole length
        }

        return near < pieces.Count;
    }

    private static double Turn(Vector2D from, Vector2D to) => from.TurnTo(to).Abs().Radians;
}
