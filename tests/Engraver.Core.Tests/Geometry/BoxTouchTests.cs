using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class BoxTouchTests
{
    private static readonly Bounds2D Box = new(0, 0, 10, 5);

    [Theory]
    [InlineData(-5, 2, 15, 3, true)]
    [InlineData(-5, 2, -1, 9, false)]
    [InlineData(-1, 4.5, 3, 8.5, false)]
    [InlineData(-1, 3, 3, 7, true)]
    [InlineData(4, -3, 4, 9, true)]
    [InlineData(11, -3, 11, 9, false)]
    public void A_line_touches_when_part_of_it_is_inside(double x1, double y1, double x2, double y2, bool touches) =>
        Assert.Equal(touches, Box.Touches(Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2))));

    [Fact]
    public void A_circle_around_the_box_does_not_touch_it() => Assert.False(Box.Touches(Circle(5, 2.5, 20)));

    [Fact]
    public void A_circle_that_comes_in_from_one_side_does() => Assert.True(Box.Touches(Circle(12, 2.5, 3)));

    [Property]
    public Property An_arc_touches_whenever_one_of_its_points_is_inside() => Prop.ForAll(Arcs.Any, arc =>
    {
        var box = Bounds2D.FromCorners(arc.PointAt(0.4), arc.PointAt(0.4)).Grown(arc.Radius * 0.01);
        var away = new Bounds2D(arc.Bounds.MaxX + 1.0, arc.Bounds.MinY, arc.Bounds.MaxX + 2.0, arc.Bounds.MaxY);
        return box.Touches(Segment.FromArc(arc)) && !away.Touches(Segment.FromArc(arc));
    });

    [Property]
    public Property A_curve_touches_whenever_one_of_its_points_is_inside() => Prop.ForAll(FreeCurves.Splines, curve =>
    {
        var place = curve.PointAt(0.43);
        var away = new Bounds2D(curve.Bounds.MaxX + 1.0, curve.Bounds.MinY, curve.Bounds.MaxX + 2.0, curve.Bounds.MaxY);
        return Bounds2D.FromCorners(place, place).Grown(1e-6).Touches(Segment.FromCurve(curve)) && !away.Touches(Segment.FromCurve(curve));
    });

    [Fact]
    public void An_ellipse_around_the_box_does_not_touch_it() =>
        Assert.False(Box.Touches(Segment.FromCurve(FreeCurves.Ellipse(5, 2.5, 20, 0.5, 0, 0, 360).ToCurve())));

    private static Segment Circle(double x, double y, double radius) => Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.Zero, Angle.FullTurn));
}
