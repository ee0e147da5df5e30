using Engraver.App.Canvas.Rasterising;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.App.Tests.Canvas.Rasterising;

public class LineRasteriserTests
{
    private const uint Red = 0xFFFF0000;

    [Fact]
    public void A_level_line_through_pixel_centres_fills_one_row_exactly()
    {
        var tile = Drawn(10.0, 20.5, 40.0, 20.5, LinePen.Hairline);

        Assert.All(Enumerable.Range(10, 30), x => Assert.Equal((0u, 255u, 0u), (Coverage(tile, x, 19), Coverage(tile, x, 20), Coverage(tile, x, 21))));
        Assert.Equal(Red, tile.Layer[(20 * PixelTile.Side) + 20]);
    }

    [Fact]
    public void A_line_between_two_rows_covers_half_of_each()
    {
        var tile = Drawn(10.0, 20.0, 40.0, 20.0, LinePen.Hairline);

        Assert.All(Enumerable.Range(11, 28), x => Assert.Equal((128u, 128u), (Coverage(tile, x, 19), Coverage(tile, x, 20))));
    }

    [Property]
    public Property Coverage_is_the_distance_from_the_bar_for_every_pixel_of_every_line() =>
        Prop.ForAll(Gen.Choose(-400, 2900).Select(tenth => tenth / 10.0).ArrayOf(4).ToArbitrary(), Gen.Elements(0.5, 1.0, 1.5, 3.0).ToArbitrary(), (ends, width) =>
        {
            var tile = Drawn(ends[0], ends[1], ends[2], ends[3], new LinePen(width));
            return AllPixels().All(pixel => Math.Abs(Coverage(tile, pixel.X, pixel.Y) - Expected(ends, width, pixel.X, pixel.Y)) <= 0.51);
        });

    [Fact]
    public void An_end_a_billion_pixels_away_changes_nothing()
    {
        var near = Drawn(-100.0, -50.0, 300.0, 150.0, LinePen.Hairline);
        var far = Drawn(-2e9, -1e9, 2e9, 1e9, LinePen.Hairline);

        var worst = Enumerable.Range(0, near.Layer.Length).Max(i => Math.Abs((int)(near.Layer[i] >> 24) - (int)(far.Layer[i] >> 24)));

        Assert.InRange(worst, 0, 1);
    }

    [Fact]
    public void Dashes_are_measured_from_the_start_of_the_line()
    {
        var forward = Drawn(10.5, 20.5, 90.5, 20.5, new LinePen(1.0, 6.0, 4.0));
        var backward = Drawn(90.5, 20.5, 10.5, 20.5, new LinePen(1.0, 6.0, 4.0));

        Assert.Equal(255u, Coverage(forward, 11, 20));
        Assert.Equal(0u, Coverage(forward, 18, 20));
        Assert.Equal(255u, Coverage(forward, 21, 20));
        Assert.Equal(0u, Coverage(backward, 82, 20));
        Assert.Equal(255u, Coverage(backward, 89, 20));
    }

    [Fact]
    public void A_point_is_a_dot_and_what_lies_outside_draws_nothing()
    {
        Assert.Equal(255u, Coverage(Drawn(5.5, 5.5, 5.5, 5.5, LinePen.Hairline), 5, 5));
        Assert.All(Drawn(-50.0, -3.0, 400.0, -3.0, LinePen.Hairline).Layer, pixel => Assert.Equal(0u, pixel));
        Assert.All(Drawn(300.0, 10.0, 400.0, 1000.0, LinePen.Hairline).Layer, pixel => Assert.Equal(0u, pixel));
    }

    [Fact]
    public void Composed_pixels_are_mixed_by_coverage_and_the_layer_is_clean_again()
    {
        var tile = Drawn(10.0, 20.0, 40.0, 20.0, LinePen.Hairline);
        var pixels = new uint[PixelTile.Side * PixelTile.Side];
        Array.Fill(pixels, 0xFF0000FF);

        tile.Compose(pixels, PixelTile.Side);

        Assert.Equal(0xFF80007Fu, pixels[(19 * PixelTile.Side) + 20]);
        Assert.Equal(0xFF0000FFu, pixels[(18 * PixelTile.Side) + 20]);
        Assert.All(tile.Layer, pixel => Assert.Equal(0u, pixel));
    }

    private static PixelTile Drawn(double fromX, double fromY, double toX, double toY, LinePen pen)
    {
        var tile = new PixelTile();
        tile.MoveTo(0, 0, PixelTile.Side, PixelTile.Side);
        LineRasteriser.Draw(tile, fromX, fromY, toX, toY, Red, pen);
        return tile;
    }

    private static uint Coverage(PixelTile tile, int x, int y) => tile.Layer[(y * PixelTile.Side) + x] >> 24;

    private static IEnumerable<(int X, int Y)> AllPixels() => Enumerable.Range(0, PixelTile.Side * PixelTile.Side).Select(i => (i % PixelTile.Side, i / PixelTile.Side));

    private static double Expected(double[] ends, double width, int x, int y)
    {
        var line = new Engraver.Core.Geometry.LineSegment(new(ends[0], ends[1]), new(ends[2], ends[3]));
        return 255.0 * Math.Clamp((width / 2.0) + 0.5 - line.DistanceTo(new(x + 0.5, y + 0.5)), 0.0, 1.0);
    }
}
