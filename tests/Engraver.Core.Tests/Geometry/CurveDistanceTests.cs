using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Geometry;

/// <summary>Distances to ellipses and splines, compared with an evaluation that shares no code with the product (<see cref="DrawnCurve"/>).</summary>
public class CurveDistanceTests
{
    private const double FiveCounts = 0.005;

    public static TheoryData<string> KnownNames => [.. DrawnCurves.Known.Select(drawn => drawn.Name)];

    /// <summary>Curves of 10 micrometres, 10 mm, 10 m and 10 km.</summary>
    public static TheoryData<double> Sizes => [0.01, 10.0, 1e4, 1e7];

    [Theory]
    [MemberData(nameof(KnownNames))]
    public void Places_of_a_curve_are_on_it_and_all_others_are_as_far_as_they_are(string name) => Check(DrawnCurves.Known.Single(drawn => drawn.Name == name), new Random(1));

    [Theory]
    [MemberData(nameof(Sizes))]
    public void Places_of_random_curves_are_on_them_and_all_others_are_as_far_as_they_are(double size)
    {
        var random = new Random(2);
        foreach (var drawn in DrawnCurves.Random(seed: 3, count: 40, size)) Check(drawn, random);
    }

    [Fact]
    public void Places_moved_five_counts_aside_are_off_by_that_unless_another_part_is_near()
    {
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 4, count: 40)))
        {
            foreach (var parameter in drawn.Parameters(5))
            {
                var along = drawn.Direction(parameter);
                if (!double.IsFinite(along.X)) continue;
                var aside = drawn.At(parameter) + (new Vector2D(-along.Y, along.X) * FiveCounts);
                AssertNear(drawn.DistanceFrom(aside), drawn.Curve.DistanceTo(aside), drawn, aside);
            }
        }
    }

    [Fact]
    public void The_middle_of_a_circle_is_as_far_as_its_radius()
    {
        var circle = RationalCurveTests.Circle();

        Assert.Equal(10.0, circle.DistanceTo(new Point2D(0, 0)), 1e-12);
        Assert.Equal(9.0, circle.DistanceTo(new Point2D(1, 0)), 1e-12);
    }

    [Theory]
    [InlineData(1e80)]
    [InlineData(1e160)]
    [InlineData(1e300)]
    public void A_place_farther_than_its_square_can_be_told_has_a_distance(double far)
    {
        foreach (var place in (Point2D[])[new(far, 0.0), new(-far, far), new(0.5, -far)])
            Assert.All(DrawnCurves.Known, drawn => Assert.Equal(1.0, drawn.Curve.DistanceTo(place) / double.Hypot(place.X, place.Y), 1e-6));
    }

    [Fact]
    public void A_window_around_a_place_of_the_curve_touches_it_and_one_beside_it_does_not()
    {
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 5, count: 40)))
        {
            var segment = Segment.FromCurve(drawn.Curve);
            foreach (var parameter in drawn.Parameters(5))
            {
                var place = drawn.At(parameter);
                Assert.True(Bounds2D.FromCorners(place, place).Grown(1e-6).Touches(segment), $"{drawn} at {place}");
                var beside = place + new Vector2D(0.0, 2.0 * FiveCounts);
                if (drawn.DistanceFrom(beside) > FiveCounts) Assert.False(Bounds2D.FromCorners(beside, beside).Grown(FiveCounts / 2.0).Touches(segment), $"{drawn} beside {place}");
            }
        }
    }

    [Fact]
    public void Boxes_and_lengths_are_those_of_a_fine_chain_of_places()
    {
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 6, count: 40)))
        {
            var (box, length, last) = (Bounds2D.Empty, 0.0, drawn.At(drawn.Breaks[0]));
            foreach (var place in drawn.Trace(drawn.Breaks[0], drawn.Breaks[^1], 0.01))
            {
                (box, length, last) = (box.Including(place), length + last.DistanceTo(place), place);
            }

            Assert.True(drawn.Curve.Bounds.Grown(1e-9).Contains(box) && box.Grown(0.005).Contains(drawn.Curve.Bounds), $"box of {drawn}");
            Assert.True(Math.Abs(drawn.Curve.PlanLength - length) <= 1e-3 * length, $"length of {drawn}: {drawn.Curve.PlanLength} for {length}");
        }
    }

    [Fact]
    public void The_direction_of_travel_is_known_where_the_curve_stands_still()
    {
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 7, count: 40)))
        {
            for (var i = 0; i <= 4 * drawn.Curve.Spans.Length; i++)
            {
                var tangent = drawn.Curve.TangentAt(i / (4.0 * drawn.Curve.Spans.Length));
                Assert.True(Math.Abs(tangent.Length - 1.0) < 1e-12, $"{drawn} at {i}");
            }
        }
    }

    [Fact]
    public void Pieces_are_few_and_their_speed_is_even_enough_to_be_walked_by_the_parameter()
    {
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 8, count: 60)))
        {
            Assert.InRange(drawn.Curve.Pieces().Count, 1, 200 * drawn.Curve.Spans.Length);
            foreach (var piece in drawn.Curve.Pieces())
            {
                var longest = Enumerable.Range(0, 64).Max(i => piece.PointAt(i / 64.0).DistanceTo(piece.PointAt((i + 1) / 64.0)));
                Assert.True(longest * 64.0 <= (8.0 * piece.PlanLength) + (1e-3 * drawn.Size), $"{drawn}: a step of {longest} on a piece of {piece.PlanLength}");
            }
        }
    }

    private static void Check(DrawnCurve drawn, Random random)
    {
        foreach (var parameter in drawn.Parameters(23)) AssertNear(0.0, drawn.Curve.DistanceTo(drawn.At(parameter)), drawn, drawn.At(parameter));
        var box = drawn.Curve.Bounds.Grown(0.3 * drawn.Size);
        for (var i = 0; i < 6; i++)
        {
            var place = new Point2D(box.MinX + (box.Width * random.NextDouble()), box.MinY + (box.Height * random.NextDouble()));
            AssertNear(drawn.DistanceFrom(place), drawn.Curve.DistanceTo(place), drawn, place);
        }
    }

    private static void AssertNear(double expected, double found, DrawnCurve drawn, Point2D place) =>
        Assert.True(Math.Abs(expected - found) <= 1e-9 * drawn.Size, $"{drawn} at {place}: {found} for {expected}");
}
