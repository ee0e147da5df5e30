using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;

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

    [Fact]
    public void An_arc_and_its_points_go_the_same_way() => Prop.ForAll(Arcs.Any, Any, (arc, map) =>
    {
        var mapped = map.Apply(arc);
        return new[] { 0.0, 0.3, 1.0 }.All(at => map.Apply(arc.PointAt(at)).IsNear(mapped.PointAt(at), 1e-9 * (1.0 + arc.Radius) * 1000.0));
    }).QuickCheckThrowOnFailure();

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
