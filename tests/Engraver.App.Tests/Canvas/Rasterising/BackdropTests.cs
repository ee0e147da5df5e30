using Avalonia;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.App.Tests.Canvas.Rasterising;

public class BackdropTests
{
    [Property]
    public Property Grid_steps_are_one_two_or_five_and_never_denser_than_ten_pixels() =>
        Prop.ForAll(Gen.Choose(-9000, 9000).ToArbitrary(), thousandths =>
        {
            var unitsPerPixel = Math.Pow(10.0, thousandths / 1000.0);
            var step = GridStep.For(unitsPerPixel);
            var mantissa = step.Minor / Math.Pow(10.0, Math.Floor(Math.Log10(step.Minor * 1.0000001)));
            var pixels = step.Minor / unitsPerPixel;
            return pixels >= GridStep.MinPixels * 0.999999 && pixels <= GridStep.MinPixels * 2.6 && new[] { 1.0, 2.0, 5.0 }.Any(digit => Math.Abs(mantissa - digit) < 1e-6);
        });

    [Fact]
    public void Axes_grid_and_background_have_their_own_colours()
    {
        var view = new CanvasView(Point2D.Origin, 1.0, new PixelSize(301, 301));
        var picture = new Picture(view);

        Backdrop.For(view, CanvasTheme.Dark, grid: true).Fill(picture, 0, 0, 301, 301);

        Assert.Equal(CanvasTheme.Dark.AxisX, picture.Pixels[(150 * 301) + 5]);
        Assert.Equal(CanvasTheme.Dark.AxisY, picture.Pixels[(5 * 301) + 150]);
        Assert.Equal(CanvasTheme.Dark.MinorGrid, picture.Pixels[(5 * 301) + 160]);
        Assert.Equal(CanvasTheme.Dark.MajorGrid, picture.Pixels[(5 * 301) + 250]);
        Assert.Equal(CanvasTheme.Dark.Background, picture.Pixels[(5 * 301) + 5]);
    }

    /// <summary>Regression: lines were counted in a double that adding one did not change, in an endless loop on every core.</summary>
    [Theory]
    [InlineData(5e6, 1e-12)]
    [InlineData(-5e6, 1e-12)]
    [InlineData(1e300, 1.0)]
    [InlineData(double.PositiveInfinity, 1.0)]
    [InlineData(0.0, double.PositiveInfinity)]
    public void Where_numbers_cannot_tell_grid_lines_apart_there_are_none(double centre, double unitsPerPixel)
    {
        var view = new CanvasView(new Point2D(centre, centre), unitsPerPixel, new PixelSize(50, 50));
        var picture = new Picture(view);

        Backdrop.For(view, CanvasTheme.Light, grid: true).Fill(picture, 0, 0, 50, 50);

        Assert.All(picture.Pixels, pixel => Assert.Equal(0xFFFFFFFF, pixel));
    }

    [Fact]
    public void A_grid_that_is_off_leaves_the_background()
    {
        var view = new CanvasView(Point2D.Origin, 1.0, new PixelSize(50, 50));
        var picture = new Picture(view);

        Backdrop.For(view, CanvasTheme.Light, grid: false).Fill(picture, 0, 0, 50, 50);

        Assert.All(picture.Pixels, pixel => Assert.Equal(0xFFFFFFFF, pixel));
    }
}
