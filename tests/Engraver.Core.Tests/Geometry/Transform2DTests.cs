using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class Transform2DTests
{
    private static readonly Arbitrary<Transform2D> Any = (
        from turn in Gen.Choose(-720, 720)
        from factor in Gen.Choose(1, 400)
        from mirrored in Gen.Elements(true, false)
        from x in Gen.Choose(-500, 500)
        from y in Gen.Choose(-500, 500)
        select new Transform2D(factor / 100.0, Angle.FromDegrees(turn / 2.0), mirrored, new Vector2D(x / 10.0, y / 10.0))).ToArbitrary();

    [Property]
    public Property An_arc_and_its_points_go_the_same_way() => Prop.ForAll(Arcs.Any, Any, (arc, map) =>
    {
        var mapped = map.Apply(arc);
        return new[] { 0.0, 0.3, 1.0 }.All(at => map.Apply(arc.PointAt(at)).IsNear(mapped.PointAt(at), 1e-9 * (1.0 + arc.Radius) * 1000.0));
    });

    [Property]
    public Property Maps_are_joined_and_inverted() => Prop.ForAll(Any, Any, (inner, outer) =>
    {
        var place = new Point2D(3.0, -7.0);
        return outer.After(inner).Apply(place).IsNear(outer.Apply(inner.Apply(place)), 1e-8) && inner.Inverse().Apply(inner.Apply(place)).IsNear(place, 1e-8);
    });

    [Property]
    public Property Lengths_and_directions_go_with_the_map() => Prop.ForAll(Arcs.Any, Any, (arc, map) =>
    {
        var (before, after) = (Segment.FromArc(arc), Segment.FromArc(map.Apply(arc)));
        var tangent = map.Apply(new Point2D(0, 0) + before.StartTangent) - map.Apply(new Point2D(0, 0));
        return Math.Abs(after.Length - (map.Scale * before.Length)) <= 1e-9 * (1.0 + after.Length)
            && (after.StartTangent - (tangent * (1.0 / map.Scale))).Length < 1e-9
            && after.Bounds is var box && Enumerable.Range(0, 33).Select(i => map.Apply(before.PointAt(i / 32.0))).All(place =>
                place.X >= box.MinX - 1e-6 && place.X <= box.MaxX + 1e-6 && place.Y >= box.MinY - 1e-6 && place.Y <= box.MaxY + 1e-6);
    });

    [Property]
    public Property A_curve_and_its_places_go_the_same_way_and_its_length_is_scaled() => Prop.ForAll(FreeCurves.Splines, Any, (curve, map) =>
    {
        var mapped = curve.Mapped(map);
        return Math.Abs(mapped.PlanLength - (map.Scale * curve.PlanLength)) <= 1e-9 * (1.0 + mapped.PlanLength)
            && Enumerable.Range(0, 17).All(i => mapped.PointAt(i / 16.0).IsNear(map.Apply(curve.PointAt(i / 16.0)), 1e-8));
    });

    [Fact]
    public void A_mirror_turns_the_sense_round_and_a_whole_turn_stays_whole()
    {
        var circle = new ArcSegment(new Point2D(3, 4), 2, Angle.Zero, Angle.FullTurn);
        var mirrored = Transform2D.MirrorAt(new Point2D(0, 7), new Point2D(10, 7)).Apply(circle);

        Assert.Equal(new Point2D(3, 10), mirrored.Centre);
        Assert.Equal(-360.0, mirrored.Sweep.Degrees);
    }

    [Fact]
    public void Quarter_turns_about_a_point_are_exact()
    {
        var quarter = Transform2D.Rotate(new Point2D(10, 20), Angle.FromDegrees(90));

        Assert.Equal(new Point2D(10, 21), quarter.Apply(new Point2D(11, 20)));
        Assert.Equal(new Point2D(10, 20), quarter.Apply(new Point2D(10, 20)));
    }

    [Fact]
    public void Points_of_the_mirror_line_stay_where_they_are()
    {
        var mirror = Transform2D.MirrorAt(new Point2D(1, 2), new Point2D(4, 6));

        Assert.True(mirror.Apply(new Point2D(7, 10)).IsNear(new Point2D(7, 10), 1e-12));
        Assert.True(Transform2D.ScaleFrom(new Point2D(1, 1), 3).Apply(new Point2D(2, 3)) == new Point2D(4, 7));
    }
}
