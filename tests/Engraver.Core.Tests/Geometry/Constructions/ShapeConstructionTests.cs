using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry.Constructions;

/// <summary>Circles, ellipses, polygons and rectangles, compared with their definitions.</summary>
public class ShapeConstructionTests
{
    private const double Near = 1e-9;

    [Property]
    public Property A_circle_through_three_points_is_as_far_from_each_of_them() =>
        Prop.ForAll(Places(), Places(), Places(), (a, b, c) =>
        {
            if (CircleConstruction.ThroughPoints(a, b, c) is not { } circle) return Math.Abs((b - a).Cross(c - a)) < 1e-6 * (b - a).Length * (c - a).Length || b.DistanceTo(c) < 1e-6;
            return new[] { a, b, c }.All(place => Math.Abs(circle.Centre.DistanceTo(place) - circle.Radius) <= Near * (circle.Radius + 1000.0)) && circle.IsFullTurn;
        });

    [Fact]
    public void A_circle_on_a_diameter()
    {
        var circle = CircleConstruction.FromDiameter(new Point2D(1, 2), new Point2D(7, 10))!.Value;

        Assert.Equal((new Point2D(4, 6), 5.0), (circle.Centre, circle.Radius));
        Assert.Null(CircleConstruction.FromDiameter(new Point2D(1, 2), new Point2D(1, 2)));
    }

    [Fact]
    public void A_circle_touches_two_lines_where_they_were_pointed_at()
    {
        var (level, upright) = (Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0)), Segment.FromLine(new Point2D(0, 0), new Point2D(0, 10)));

        Assert.Equal(new Point2D(2, 2), CircleConstruction.TangentTo((level, new Point2D(3, 0)), (upright, new Point2D(0, 3)), 2)!.Value.Centre);
        Assert.Equal(new Point2D(-2, 2), CircleConstruction.TangentTo((level, new Point2D(-3, 0)), (upright, new Point2D(0, 3)), 2)!.Value.Centre);
        Assert.Null(CircleConstruction.TangentTo((level, new Point2D(3, 0)), (Segment.FromLine(new Point2D(0, 5), new Point2D(9, 5)), new Point2D(3, 5)), 2));
    }

    /// <summary>Centre 0,0, radius 3, and the line y = 5: a circle of radius 1 touches both at 0,4.</summary>
    [Fact]
    public void A_circle_touches_a_line_and_a_circle()
    {
        var (line, round) = (Segment.FromLine(new Point2D(-9, 5), new Point2D(9, 5)), Segment.FromArc(new ArcSegment(default, 3, Angle.Zero, Angle.FullTurn)));

        Assert.Equal(new Point2D(0, 4), CircleConstruction.TangentTo((line, new Point2D(1, 5)), (round, new Point2D(0, 3)), 1)!.Value.Centre);
    }

    [Property]
    public Property A_circle_that_touches_two_circles_is_at_its_radius_from_both() =>
        Prop.ForAll(Places(), Places(), Gen.Choose(1, 500).Select(tenths => tenths / 10.0).ToArbitrary(), (one, other, radius) =>
        {
            var (a, b) = (new ArcSegment(one, 20, Angle.Zero, Angle.FullTurn), new ArcSegment(other, 35, Angle.Zero, Angle.FullTurn));
            if (CircleConstruction.TangentTo((Segment.FromArc(a), a.StartPoint), (Segment.FromArc(b), b.StartPoint), radius) is not { } circle) return one.DistanceTo(other) > 55.0 || one.DistanceTo(other) < 56.0;
            return Touches(a) && Touches(b);

            bool Touches(ArcSegment given)
            {
                var apart = circle.Centre.DistanceTo(given.Centre);
                return Math.Min(Math.Abs(apart - given.Radius - radius), Math.Abs(apart - Math.Abs(given.Radius - radius))) <= 1e-6;
            }
        });

    /// <summary>x / a and y / b of every point of an ellipse make 1, in the directions of its axes.</summary>
    [Property]
    public Property Every_point_of_an_ellipse_fulfils_its_equation() =>
        Prop.ForAll(Places(), Places(), Gen.Choose(1, 300).Select(tenths => tenths / 10.0).ToArbitrary(), (centre, toEnd, second) =>
        {
            var first = toEnd - Point2D.Origin;
            if (EllipseConstruction.FromAxes(centre, first, second, Angle.FromDegrees(30), Angle.FromDegrees(300)) is not { } ellipse) return first.Length < 1e-3;
            var curve = ellipse.ToCurve();
            return Enumerable.Range(0, 21).Select(i => curve.PointAt(i / 20.0) - centre).All(way =>
            {
                var (x, y) = (way.Dot(first) / first.LengthSquared, first.Cross(way) / (first.Length * second));
                return Math.Abs((x * x) + (y * y) - 1.0) <= 1e-6;
            });
        });

    [Fact]
    public void The_parameter_of_an_angle_is_that_of_the_point_seen_there()
    {
        var parameter = EllipseConstruction.ParameterAt(Angle.FromDegrees(45), 10, 5);

        Assert.Equal(45.0, Math.Atan2(5 * parameter.Sin(), 10 * parameter.Cos()) * 180.0 / Math.PI, 9);
        Assert.Equal([0.0, 90.0, 180.0, 270.0], new[] { 0.0, 90.0, 180.0, 270.0 }.Select(degrees => EllipseConstruction.ParameterAt(Angle.FromDegrees(degrees), 10, 5).Degrees));
        Assert.Equal(5.0, EllipseConstruction.Turned(10, Angle.FromDegrees(60)), 9);
        Assert.Null(EllipseConstruction.FromAxes(default, default, 5, Angle.Zero, Angle.FullTurn));
        Assert.Null(EllipseConstruction.FromAxes(default, new Vector2D(1, 0), 1e-7, Angle.Zero, Angle.FullTurn));
    }

    [Property]
    public Property The_sides_of_a_regular_polygon_are_equally_long_and_stand_equally_far_from_the_centre() =>
        Prop.ForAll(Gen.Choose(3, 40).ToArbitrary(), Places(), Places(), (sides, centre, place) =>
        {
            var radius = centre.DistanceTo(place);
            if (radius < 1.0) return true;
            var (within, about) = (PolygonConstruction.Inscribed(centre, place, sides), PolygonConstruction.Circumscribed(centre, place, sides));
            var near = Near * (radius + 1000.0);
            return within[0] == place && within.All(corner => Math.Abs(corner.DistanceTo(centre) - radius) <= near)
                && IsRegular(within, 2.0 * radius * Math.Sin(Math.PI / sides), near) && IsRegular(about, 2.0 * radius * Math.Tan(Math.PI / sides), near)
                && PolygonConstruction.Outline(about).Min(side => side.DistanceTo(place)) <= near;
        });

    [Fact]
    public void A_polygon_on_an_edge_has_it_as_its_first_side_and_lies_left_of_it()
    {
        var square = PolygonConstruction.OnEdge(new Point2D(2, 1), new Point2D(5, 1), 4);

        Assert.Equal(["2,1", "5,1", "5,4", "2,4"], square.Select(corner => FormattableString.Invariant($"{Math.Round(corner.X, 9)},{Math.Round(corner.Y, 9)}")));
    }

    [Fact]
    public void A_turned_rectangle_has_the_sides_between_its_corners()
    {
        var turn = Angle.FromDegrees(30);
        var corners = PolygonConstruction.Rectangle(new Point2D(3, 4), new Vector2D(20, -10), turn);

        Assert.Equal([20.0, 10.0, 20.0, 10.0], PolygonConstruction.Outline(corners).Select(side => Math.Round(side.Length, 9)));
        var sides = PolygonConstruction.SidesOf(corners[0], corners[2], turn);
        Assert.Equal((20.0, -10.0), (Math.Round(sides.X, 9), Math.Round(sides.Y, 9)));
        Assert.Equal(30.0, (corners[1] - corners[0]).Direction.Degrees, 9);
    }

    /// <summary>4 by 3 with radius 1: straight lengths 2 and 1, four quarters of a circle, which every line meets smoothly.</summary>
    [Theory]
    [InlineData(4, 3)]
    [InlineData(-4, 3)]
    [InlineData(4, -3)]
    public void Rounded_corners_are_quarter_circles_that_lines_meet_smoothly(double length, double width)
    {
        var outline = CornerCut.FromRadius(1).Apply(PolygonConstruction.Rectangle(new Point2D(5, 5), new Vector2D(length, width), Angle.Zero));

        Assert.Equal(8, outline.Count);
        Assert.Equal(6.0 + (2.0 * Math.PI), outline.Sum(segment => segment.Length), 9);
        for (var i = 0; i < outline.Count; i++)
        {
            var next = outline[(i + 1) % outline.Count];
            Assert.True(outline[i].End.IsNear(next.Start, Near) && outline[i].EndTangent.Dot(next.StartTangent) > 1.0 - Near);
        }
    }

    [Fact]
    public void Corners_are_cut_off_by_two_distances_unless_a_side_is_too_short()
    {
        var corners = PolygonConstruction.Rectangle(default, new Vector2D(10, 5), Angle.Zero);

        Assert.Equal(8, CornerCut.Chamfer(1, 2).Apply(corners).Count);
        Assert.Equal(new Point2D(9, 0), CornerCut.Chamfer(1, 2).Apply(corners)[1].Start);
        Assert.Equal(new Point2D(10, 2), CornerCut.Chamfer(1, 2).Apply(corners)[1].End);
        Assert.Equal(4, CornerCut.Chamfer(3, 3).Apply(corners).Count);
        Assert.Equal(6, CornerCut.FromRadius(2.5).Apply(corners).Count);
    }

    private static bool IsRegular(IReadOnlyList<Point2D> corners, double side, double near) => PolygonConstruction.Outline(corners).All(edge => Math.Abs(edge.Length - side) <= near * 10.0);

    private static Arbitrary<Point2D> Places() => (from x in Gen.Choose(-100_000, 100_000) from y in Gen.Choose(-100_000, 100_000) select new Point2D(x / 1000.0, y / 1000.0)).ToArbitrary();
}
