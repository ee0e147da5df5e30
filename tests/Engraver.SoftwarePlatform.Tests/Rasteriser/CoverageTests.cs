using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Rasteriser;

public class CoverageTests
{
    private static readonly PixelBounds s_page = new(0, 0, 100, 100);

    [Fact]
    public void A_circle_covers_its_area()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddEllipse(new Rect(10.3, 12.7, 60, 60));

        Near.Equal(Math.PI * 30 * 30, Area(path), 2.5);
    }

    [Fact]
    public void Even_odd_leaves_the_inner_circle_out_and_non_zero_does_not()
    {
        var path = new VectorPath(FillRule.EvenOdd);
        path.AddEllipse(new Rect(10, 10, 80, 80));
        path.AddEllipse(new Rect(30, 30, 40, 40));

        Near.Equal(Math.PI * (1600 - 400), Area(path), 2.5);
        path.FillRule = FillRule.NonZero;
        Near.Equal(Math.PI * 1600, Area(path), 3.5);
    }

    [Fact]
    public void A_triangle_with_corners_between_pixels_covers_half_of_base_times_height()
    {
        var path = Polygon((10.25, 20.5), (70.75, 33.125), (22.5, 88.875));

        var twice = (70.75 - 10.25) * (88.875 - 20.5) - (22.5 - 10.25) * (33.125 - 20.5);
        Near.Equal(twice / 2, Area(path), 0.6);
    }

    [Fact]
    public void What_lies_left_of_the_page_still_covers_the_page_and_what_lies_right_does_not()
    {
        var path = Polygon((-50, 10), (150, 10), (150, 20), (-50, 20));
        var outside = Polygon((100, 0), (200, 0), (150, 100));

        Near.Equal(1000, Area(path), 0.01);
        Assert.Equal(0, Area(outside));
    }

    [Fact]
    public void A_slanted_edge_covers_its_pixels_exactly()
    {
        // From (0,0) to (4,1): pixel i of the row is covered by the part under the line.
        var path = Polygon((0, 0), (4, 1), (0, 1));
        using var mask = Mask(path);

        Assert.Equal([223, 159, 96, 32], mask.Row(0, 0, 4).ToArray().Select(cell => (int)cell));
    }

    [Fact]
    public void The_accumulator_is_clean_for_the_next_shape()
    {
        var first = Polygon((3.5, 3.5), (90, 40), (20, 95));
        var second = Polygon((40, 40), (60, 40), (60, 60), (40, 60));

        Assert.True(Area(first) > 0);
        Near.Equal(400, Area(second), 0.01);
        Near.Equal(400, Area(second), 0.01);
    }

    [Fact]
    public void Points_that_are_no_numbers_draw_nothing_and_break_nothing()
    {
        var path = Polygon((10, 10), (double.NaN, 50), (double.PositiveInfinity, 20), (50, 10), (50, 50), (10, 50));

        Assert.InRange(Area(path), 0, 10000);
        Near.Equal(100, Area(Polygon((0, 0), (10, 0), (10, 10), (0, 10))), 0.01);
    }

    [Fact]
    public void A_rounded_rectangle_lacks_its_corners()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddRoundedRectangle(new RoundedRect(new Rect(10, 10, 60, 40), 8));

        Near.Equal(60 * 40 - (4 - Math.PI) * 64, Area(path), 0.9);
    }

    private static VectorPath Polygon(params (double X, double Y)[] corners)
    {
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(corners[0].X, corners[0].Y));
        foreach (var (x, y) in corners[1..])
            path.LineTo(new Point(x, y));
        path.Close();
        return path;
    }

    private static double Area(VectorPath path)
    {
        using var mask = Mask(path);
        return mask.Cells.ToArray().Sum(cell => cell / 255.0);
    }

    private static CoverageMask Mask(VectorPath path)
    {
        var scratch = DrawingScratch.Take();
        var mask = ShapeFiller.MaskOf(scratch, path, Matrix.Identity, s_page);
        scratch.GiveBack();
        return mask;
    }
}
