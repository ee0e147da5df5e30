using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Drawings;

public class DrawingPickTests
{
    private static readonly Drawing WithEllipse = new DrawingBuilder().Line(0, 0, 10, 0).Free(FreeCurves.Ellipse(50, 50, 20, 0.5, 0, 0, 360).ToCurve()).Build();

    [Fact]
    public void An_ellipse_is_picked_on_its_curve_and_not_at_its_centre()
    {
        Assert.Equal(1, DrawingPick.Nearest(WithEllipse, new Point2D(50, 60.01), 0.1));
        Assert.Null(DrawingPick.Nearest(WithEllipse, new Point2D(50, 50), 1.0));
    }

    [Fact]
    public void A_crossing_box_takes_the_ellipse_that_it_touches_and_a_window_only_a_whole_one()
    {
        Assert.Equal([1], DrawingPick.Touching(WithEllipse, new Bounds2D(69, 49, 71, 51)));
        Assert.Empty(DrawingPick.Inside(WithEllipse, new Bounds2D(69, 49, 71, 51)));
        Assert.Equal([1], DrawingPick.Inside(WithEllipse, new Bounds2D(29, 39, 71, 61)));
    }

    [Fact]
    public void The_box_of_an_ellipse_is_tight()
    {
        var box = DrawingPick.BoundsOf(WithEllipse, [1]);

        Assert.Equal((30.0, 40.0, 70.0, 60.0), (Math.Round(box.MinX, 9), Math.Round(box.MinY, 9), Math.Round(box.MaxX, 9), Math.Round(box.MaxY, 9)));
    }
}
