using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Tests.Views;

public class ViewSessionTests
{
    private readonly ViewSession _view = new();

    [Fact]
    public void Zooming_about_a_place_leaves_it_where_it_is_on_the_canvas()
    {
        _view.SetCentre(new Point2D(10, 20), 100);
        var place = new Point2D(35, -5);
        var before = (place - _view.Current.Centre) * (1.0 / _view.Current.Height);

        _view.ZoomAbout(place, 2.5);
        var after = (place - _view.Current.Centre) * (1.0 / _view.Current.Height);

        Assert.Equal(40.0, _view.Current.Height, precision: 12);
        Assert.Equal(before.X, after.X, precision: 12);
        Assert.Equal(before.Y, after.Y, precision: 12);
    }

    [Fact]
    public void Panning_takes_the_drawing_with_the_hand()
    {
        _view.SetCentre(new Point2D(10, 20), 100);
        _view.PanBy(new Vector2D(3, -4));

        Assert.Equal(new Point2D(7, 24), _view.Current.Centre);
    }

    [Theory]
    [InlineData(2.0, 50.0)]
    [InlineData(0.5, 160.0)]
    public void A_window_is_seen_whole_whatever_the_shape_of_the_canvas(double aspect, double height)
    {
        _view.SetAspect(aspect);
        _view.SetWindow(new Bounds2D(0, 0, 80, 50));

        Assert.Equal(height, _view.Current.Height, precision: 12);
        Assert.True(_view.Current.Window.Contains(new Bounds2D(0, 0, 80, 50)));
        Assert.Equal(new Point2D(40, 25), _view.Current.Centre);
    }

    [Fact]
    public void Extents_leave_out_what_cannot_be_seen()
    {
        var drawing = new DrawingBuilder().Circle(0, 0, 10)
            .OnLayer(new Layer("frozen", On: true, Frozen: true, Plot: true)).Line(0, 0, 5000, 0)
            .OnLayer(new Layer("off", On: false, Frozen: false, Plot: true)).Line(0, 0, 0, 7000)
            .OnLayer(new Layer("guides", On: true, Frozen: false, Plot: false)).Line(0, 0, 0, -20).Build();

        Assert.Equal(new Bounds2D(-10, -20, 10, 10), _view.ExtentsOf(drawing));
        Assert.True(_view.ZoomExtents(drawing));
        Assert.Equal(new Point2D(0, -5), _view.Current.Centre);
    }

    [Fact]
    public void An_empty_drawing_leaves_the_view_as_it_is()
    {
        Assert.False(_view.ZoomExtents(new DrawingBuilder().Build()));
        Assert.Equal(ViewState.Default, _view.Current);
    }

    [Fact]
    public void Previous_goes_back_through_the_last_ten_views()
    {
        for (var i = 1; i <= 12; i++) _view.SetCentre(new Point2D(i, 0), i);
        for (var i = 11; i >= 2; i--)
        {
            Assert.True(_view.ZoomPrevious());
            Assert.Equal((i, (double)i), ((int)_view.Current.Centre.X, _view.Current.Height));
        }

        Assert.False(_view.ZoomPrevious());
    }

    [Fact]
    public void A_single_point_is_brought_into_the_middle_without_changing_the_scale()
    {
        _view.SetCentre(new Point2D(0, 0), 30);
        _view.SetWindow(Bounds2D.FromCorners(new Point2D(5, 5), new Point2D(5, 5)));

        Assert.Equal((new Point2D(5, 5), 30.0), (_view.Current.Centre, _view.Current.Height));
    }

    [Fact]
    public void A_marker_is_shown_until_everything_is_drawn_anew()
    {
        _view.FocusOn(new ViewFocus(new Point2D(3, 4), null), height: 5);
        Assert.Equal((new Point2D(3, 4), 5.0, new Point2D(3, 4)), (_view.Current.Centre, _view.Current.Height, _view.Current.Focus!.Place));

        _view.Regenerate();
        Assert.Null(_view.Current.Focus);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(-1.0)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void Nonsense_from_a_mouse_or_a_layout_changes_nothing(double value)
    {
        _view.ZoomAbout(default, value);
        _view.SetAspect(value);

        Assert.Equal(ViewState.Default, _view.Current);
    }

    [Fact]
    public void A_change_is_told_once_and_no_change_is_not_told()
    {
        var told = 0;
        _view.Changed += (_, _) => told++;
        _view.Change(state => state with { Grid = false });
        _view.Change(state => state with { Grid = false });

        Assert.Equal(1, told);
    }
}
