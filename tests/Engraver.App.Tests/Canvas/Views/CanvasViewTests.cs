using Avalonia;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;
using FsCheck.Xunit;

namespace Engraver.App.Tests.Canvas.Views;

public class CanvasViewTests
{
    private static readonly CanvasView s_view = new(new Point2D(120.0, -30.0), 0.25, new PixelSize(801, 600));

    [Fact]
    public void The_middle_of_the_picture_is_the_centre_and_y_grows_downwards()
    {
        Assert.Equal(new Point2D(400.5, 300.0), s_view.ToPixels(s_view.Centre));
        Assert.Equal(new Point2D(404.5, 296.0), s_view.ToPixels(new Point2D(121.0, -29.0)));
    }

    [Property]
    public bool There_and_back_is_the_same_place(int x, int y)
    {
        var place = new Point2D(x % 5000, y % 5000);
        return s_view.ToPixels(s_view.ToDrawing(place)).IsNear(place, 1e-9);
    }

    [Theory]
    [InlineData(1.25)]
    [InlineData(0.8)]
    [InlineData(1e6)]
    public void Zooming_keeps_the_place_under_the_cursor(double factor)
    {
        var cursor = new Point2D(700.0, 50.0);

        var zoomed = s_view.ZoomedAbout(cursor, factor);

        Assert.Equal(s_view.UnitsPerPixel / factor, zoomed.UnitsPerPixel);
        Assert.True(zoomed.ToPixels(s_view.ToDrawing(cursor)).IsNear(cursor, 1e-5));
    }

    [Fact]
    public void Panning_moves_every_place_by_the_same_pixels()
    {
        var panned = s_view.PannedBy(new Vector2D(17.0, -5.0));

        Assert.True(panned.ToPixels(Point2D.Origin).IsNear(s_view.ToPixels(Point2D.Origin) + new Vector2D(17.0, -5.0), 1e-9));
    }

    [Fact]
    public void A_fitted_box_is_seen_whole_with_its_margin()
    {
        var view = CanvasView.Fitting(new Bounds2D(0.0, 0.0, 300.0, 10.0), new PixelSize(600, 400), margin: 0.05);

        Assert.Equal(30.0, view.ToPixels(new Point2D(0.0, 5.0)).X, 9);
        Assert.Equal(570.0, view.ToPixels(new Point2D(300.0, 5.0)).X, 9);
        Assert.Equal(200.0, view.ToPixels(new Point2D(0.0, 5.0)).Y, 9);
    }

    [Fact]
    public void A_box_that_is_a_point_or_empty_still_gives_a_view()
    {
        Assert.True(CanvasView.Fitting(Bounds2D.Empty, new PixelSize(10, 10)).UnitsPerPixel > 0.0);
        var point = CanvasView.Fitting(new Bounds2D(3.0, 4.0, 3.0, 4.0), new PixelSize(10, 10));
        Assert.Equal(new Point2D(3.0, 4.0), point.Centre);
        Assert.True(point.UnitsPerPixel > 0.0);
    }
}
