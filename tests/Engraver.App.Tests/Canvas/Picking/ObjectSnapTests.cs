using Engraver.App.Canvas.Picking;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.TestKit;

namespace Engraver.App.Tests.Canvas.Picking;

public class ObjectSnapTests
{
    private static readonly CanvasScene s_scene = CanvasScene.From(new DrawingBuilder()
        .Line(0.0, 0.0, 100.0, 0.0).Line(30.0, -40.0, 30.0, 90.0).Circle(200.0, 0.0, 50.0).Arc(0.0, 200.0, 40.0, 0.0, 180.0)
        .Free(FreeCurves.Ellipse(300.0, 300.0, 60.0, 0.5, 0.0, 0.0, 360.0).ToCurve()).Line(100.0, -60.0, 200.0, 40.0).Build());

    [Theory]
    [InlineData(1.0, 2.0, 0.0, 0.0, SnapKinds.End)]
    [InlineData(51.0, -2.0, 50.0, 0.0, SnapKinds.Middle)]
    [InlineData(31.0, 1.0, 30.0, 0.0, SnapKinds.Intersection)]
    [InlineData(248.0, 2.0, 250.0, 0.0, SnapKinds.Quadrant)]
    [InlineData(201.0, 1.0, 200.0, 0.0, SnapKinds.Centre)]
    [InlineData(39.0, 201.0, 40.0, 200.0, SnapKinds.End)]
    [InlineData(1.0, 241.0, 0.0, 240.0, SnapKinds.Middle)]
    [InlineData(299.0, 301.0, 300.0, 300.0, SnapKinds.Centre)]
    [InlineData(300.0, 331.0, 300.0, 330.0, SnapKinds.Quadrant)]
    public void The_nearest_place_is_found(double x, double y, double expectedX, double expectedY, SnapKinds kind)
    {
        var snap = ObjectSnap.Find(s_scene, new Point2D(x, y), 4.0, SnapKinds.All);

        Assert.NotNull(snap);
        Assert.Equal(kind, snap.Value.Kind);
        Assert.True(snap.Value.Place.IsNear(new Point2D(expectedX, expectedY), 1e-9));
    }

    [Fact]
    public void A_circle_under_the_cursor_offers_its_centre()
    {
        var onRim = new Point2D(200.0 + (50.0 * Math.Cos(1.0)), 50.0 * Math.Sin(1.0));

        Assert.Equal(new SnapPoint(new Point2D(200.0, 0.0), SnapKinds.Centre), ObjectSnap.Find(s_scene, onRim, 4.0, SnapKinds.All));
    }

    [Fact]
    public void A_line_crosses_a_circle_where_it_should()
    {
        var snap = ObjectSnap.Find(s_scene, new Point2D(152.0, -9.0), 8.0, SnapKinds.Intersection);

        Assert.NotNull(snap);
        Assert.Equal(50.0, snap.Value.Place.DistanceTo(new Point2D(200.0, 0.0)), 9);
        Assert.Equal(snap.Value.Place.X - 160.0, snap.Value.Place.Y, 9);
    }

    [Fact]
    public void Kinds_that_are_off_and_places_out_of_reach_are_not_offered()
    {
        Assert.Null(ObjectSnap.Find(s_scene, new Point2D(1.0, 2.0), 4.0, SnapKinds.Middle));
        Assert.Null(ObjectSnap.Find(s_scene, new Point2D(10.0, 2.0), 4.0, SnapKinds.All));
    }

    [Fact]
    public void Two_circles_cross_twice_and_those_apart_never()
    {
        var a = Segment.FromArc(new ArcSegment(new Point2D(0.0, 0.0), 5.0, Angle.Zero, Angle.FullTurn));
        var b = Segment.FromArc(new ArcSegment(new Point2D(8.0, 0.0), 5.0, Angle.Zero, Angle.FullTurn));

        Assert.Equal([new Point2D(4.0, 3.0), new Point2D(4.0, -3.0)], SegmentCrossings.Find(a, b));
        Assert.Empty(SegmentCrossings.Find(a, Segment.FromArc(new ArcSegment(new Point2D(20.0, 0.0), 5.0, Angle.Zero, Angle.FullTurn))));
        Assert.Empty(SegmentCrossings.Find(Segment.FromLine(new Point2D(0.0, 0.0), new Point2D(1.0, 1.0)), Segment.FromLine(new Point2D(5.0, 0.0), new Point2D(5.0, 9.0))));
    }
}
