using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Reshaping;

/// <summary>The fillet arc compared with independent formulas, and its tangency for every pair.</summary>
public class FilletTests
{
    private static readonly Gen<Point2D> s_places = from x in Gen.Choose(-50_000, 50_000) from y in Gen.Choose(-50_000, 50_000) select new Point2D(x / 1000.0, y / 1000.0);

    private static readonly Gen<Segment> s_segments = Gen.OneOf(
        from a in s_places from b in s_places where a.DistanceTo(b) > 0.1 select Segment.FromLine(a, b),
        Arcs.Any.Generator.Select(Segment.FromArc));

    private static readonly Arbitrary<(Segment A, Segment B, double Radius)> s_pairs =
        (from a in s_segments from b in s_segments from radius in Gen.Choose(1, 20_000) select (a, b, radius / 1000.0)).ToArbitrary();

    /// <summary>For lines that meet at an angle v the tangent points are radius / tan(v / 2) from the corner.</summary>
    [Theory]
    [InlineData(90.0, 2.0)]
    [InlineData(60.0, 1.5)]
    [InlineData(135.0, 3.25)]
    public void Two_lines_are_cut_at_the_distance_that_trigonometry_gives(double angle, double radius)
    {
        var way = Vector2D.FromPolar(50.0, Angle.FromDegrees(angle));
        var (a, b) = (Segment.FromLine(new Point2D(0, 0), new Point2D(50, 0)), Segment.FromLine(new Point2D(0, 0) + way, new Point2D(0, 0)));
        var fillet = Fillet.Create(a, new Point2D(20, 0), b, new Point2D(0, 0) + (way * 0.5), radius)!;
        var setback = radius / Math.Tan(angle / 2.0 * Math.PI / 180.0);

        Assert.Equal(setback, fillet.First!.Value.Joint.X, 12);
        Assert.Equal(setback, fillet.Second!.Value.Joint.DistanceTo(default), 12);
        Assert.Equal((false, true), (fillet.First.Value.EndsAtJoint, fillet.Second.Value.EndsAtJoint));
        Assert.Equal(180.0 - angle, Math.Abs(fillet.Between!.Value.Arc.Sweep.Degrees), 10);
        Assert.Equal(radius / Math.Sin(angle / 2.0 * Math.PI / 180.0), fillet.Between.Value.Arc.Centre.DistanceTo(default), 12);
    }

    [Fact]
    public void Lines_that_do_not_reach_each_other_are_lengthened_and_the_picked_sides_stay()
    {
        var fillet = Fillet.Create(Segment.FromLine(new Point2D(10, 0), new Point2D(30, 0)), new Point2D(12, 0), Segment.FromLine(new Point2D(0, 40), new Point2D(0, 20)), new Point2D(0, 22), 5.0)!;
        var crossed = Fillet.Create(Segment.FromLine(new Point2D(-30, 0), new Point2D(30, 0)), new Point2D(-7, 0), Segment.FromLine(new Point2D(0, 40), new Point2D(0, -20)), new Point2D(0, -9), 5.0)!;

        Assert.Equal((new Point2D(5, 0), new Point2D(0, 5)), (fillet.First!.Value.Joint, fillet.Second!.Value.Joint));
        Assert.Equal(new Point2D(5, 5), fillet.Between!.Value.Arc.Centre);
        Assert.Equal(new PathRange(0, 0.0, 25.0 / 60.0, new Point2D(-30, 0), new Point2D(-5, 0)), crossed.First!.Value.Remaining);
        Assert.Equal((new Point2D(0, -5), false), (crossed.Second!.Value.Joint, crossed.Second.Value.EndsAtJoint));
    }

    /// <summary>A line 3 above the middle of a circle of radius 10; a circle of radius 2 on the line and outside touches at a point found by
    /// Pythagoras.</summary>
    [Fact]
    public void A_line_and_a_circle()
    {
        var circle = Segment.FromArc(new ArcSegment(default, 10.0, Angle.Zero, Angle.FullTurn));
        var fillet = Fillet.Create(Segment.FromLine(new Point2D(0, 3), new Point2D(40, 3)), new Point2D(20, 3), circle, new Point2D(9, 5), 2.0)!;
        var x = Math.Sqrt((12.0 * 12.0) - (5.0 * 5.0));

        Assert.Null(fillet.Second);
        Assert.True(fillet.First!.Value.Joint.IsNear(new Point2D(x, 3), 1e-12));
        Assert.True(fillet.Between!.Value.Arc.Centre.IsNear(new Point2D(x, 5), 1e-12));
        Assert.True(fillet.Between.Value.End.IsNear(new Point2D(x * 10.0 / 12.0, 50.0 / 12.0), 1e-12));
    }

    [Fact]
    public void Parallel_lines_get_a_half_turn_whatever_the_radius()
    {
        var fillet = Fillet.Create(Segment.FromLine(new Point2D(0, 0), new Point2D(20, 0)), new Point2D(18, 0), Segment.FromLine(new Point2D(0, 6), new Point2D(31, 6)), new Point2D(10, 6), 1.0)!;

        Assert.Equal((new Point2D(20, 3), 3.0, 180.0), (fillet.Between!.Value.Arc.Centre, fillet.Between.Value.Arc.Radius, fillet.Between.Value.Arc.Sweep.Degrees));
        Assert.Equal((new Point2D(20, 6), true), (fillet.Second!.Value.Joint, fillet.Second.Value.EndsAtJoint));
        Assert.Equal(PathRange.Whole(0, Segment.FromLine(new Point2D(0, 0), new Point2D(20, 0))), fillet.First!.Value.Remaining);
    }

    [Fact]
    public void Radius_0_makes_a_corner_and_a_radius_too_large_nothing()
    {
        var (a, b) = (Segment.FromLine(new Point2D(0, 0), new Point2D(8, 0)), Segment.FromLine(new Point2D(10, 2), new Point2D(10, 9)));
        var corner = Fillet.Create(a, new Point2D(5, 0), b, new Point2D(10, 5), 0.0)!;

        Assert.Null(corner.Between);
        Assert.Equal((new Point2D(10, 0), new Point2D(10, 0)), (corner.First!.Value.Joint, corner.Second!.Value.Joint));
        Assert.Null(Fillet.Create(a, new Point2D(5, 0), b, new Point2D(10, 5), 11.0));
    }

    [Fact]
    public void A_chamfer_cuts_its_distances_off()
    {
        var (a, b) = (Segment.FromLine(new Point2D(0, 0), new Point2D(50, 0)), Segment.FromLine(new Point2D(0, 40), new Point2D(0, 0)));
        var chamfer = Fillet.Bevel(a, new Point2D(20, 0), b, new Point2D(0, 20), 3.0, 4.0)!;

        Assert.Equal((new Point2D(3, 0), new Point2D(0, 4)), (chamfer.First!.Value.Joint, chamfer.Second!.Value.Joint));
        Assert.Equal(5.0, chamfer.Between!.Value.Length, 12);
        Assert.Null(Fillet.Bevel(a, new Point2D(20, 0), b, new Point2D(0, 20), 3.0, 40.0));
    }

    /// <summary>For every pair: the arc has its radius, starts and ends on both, and continues in their directions, within 1e-9 of its size.</summary>
    [Property(MaxRejected = 10_000)]
    public Property A_fillet_arc_is_tangent_to_both() => Prop.ForAll(s_pairs, pair =>
    {
        var (a, b, radius) = pair;
        return Fillet.Create(a, a.PointAt(0.3), b, b.PointAt(0.6), radius) is { Between: { } arc } fillet
            ? (Touches(a, fillet.First, arc.Start, arc.StartTangent, arc) && Touches(b, fillet.Second, arc.End, -arc.EndTangent, arc)).ToProperty()
            : false.When(false);
    });

    private static bool Touches(Segment whole, FilletSide? side, Point2D joint, Vector2D into, Segment arc)
    {
        var size = 1e-9 * (arc.Arc.Radius + Size(whole));
        if (side is not { } kept) return Math.Abs(joint.DistanceTo(whole.Arc.Centre) - whole.Arc.Radius) <= size;
        var left = kept.Remaining.Of(whole);
        var (end, arriving) = kept.EndsAtJoint ? (left.End, left.EndTangent) : (left.Start, -left.StartTangent);
        var carrier = whole.Kind == SegmentKind.Line ? Math.Abs((whole.End - whole.Start).Cross(joint - whole.Start)) / whole.Length : Math.Abs(joint.DistanceTo(whole.Arc.Centre) - whole.Arc.Radius);
        var sine = Math.Abs(arriving.Cross(into)) * Math.Min(arc.Arc.Radius, left.Length);
        return carrier <= size && end.IsNear(joint, size) && arriving.Dot(into) > 0.0 && sine <= 10.0 * size && Math.Abs(joint.DistanceTo(arc.Arc.Centre) - arc.Arc.Radius) <= size;
    }

    private static double Size(Segment segment) => segment.Kind == SegmentKind.Line ? segment.Length + 100.0 : segment.Arc.Radius + Math.Abs(segment.Arc.Centre.X) + Math.Abs(segment.Arc.Centre.Y);

    [Fact]
    public void Lines_on_one_line_are_not_joined_whatever_their_last_digits() =>
        Assert.Null(Fillet.Create(Segment.FromLine(new Point2D(0, 0), new Point2D(0.1, 0.3)), new Point2D(0, 0), Segment.FromLine(new Point2D(0.2, 0.6), new Point2D(0.3, 0.9)), new Point2D(0.2, 0.6), 1.0));
}
