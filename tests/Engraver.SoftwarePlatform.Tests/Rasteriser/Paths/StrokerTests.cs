using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Rasteriser.Paths;

public class StrokerTests
{
    [Theory]
    [InlineData(PenLineCap.Flat, 50 * 6.0)]
    [InlineData(PenLineCap.Square, 56 * 6.0)]
    [InlineData(PenLineCap.Round, 50 * 6.0 + Math.PI * 9)]
    public void A_line_covers_its_length_times_its_width_and_its_caps(PenLineCap cap, double area)
    {
        var line = Line((20, 30), (60, 60));

        Near.Equal(area, Area(Stroker.Stroke(line, new StrokeStyle(6, cap), 1)), 1);
    }

    [Theory]
    [InlineData(PenLineJoin.Miter, 25.0)]
    [InlineData(PenLineJoin.Bevel, 12.5)]
    [InlineData(PenLineJoin.Round, Math.PI * 25 / 4)]
    public void The_outer_side_of_a_right_angle_is_filled_by_its_join(PenLineJoin join, double corner)
    {
        var angle = Line((20, 20), (60, 20), (60, 60));

        // Two legs of width 10, whose inner halves overlap in a square of 5 x 5.
        Near.Equal(2 * 40 * 10 - 25 + corner, Area(Stroker.Stroke(angle, new StrokeStyle(10, Join: join), 1)), 1);
    }

    [Fact]
    public void A_miter_longer_than_its_limit_is_cut_off()
    {
        var needle = Line((10, 50), (70, 50), (10, 56));
        double Reach(double limit) => Stroker.Stroke(needle, new StrokeStyle(4, MiterLimit: limit), 1).ControlBounds(Matrix.Identity)!.Value.Right;

        Assert.InRange(Reach(10), 70, 72.5);
        Assert.InRange(Reach(100), 100, 115);
    }

    [Fact]
    public void A_closed_circle_is_stroked_as_a_ring()
    {
        var circle = new VectorPath();
        circle.AddEllipse(new Rect(20, 20, 60, 60));

        Near.Equal(Math.PI * (33 * 33 - 27 * 27), Area(Stroker.Stroke(circle, new StrokeStyle(6), 1)), 3);
    }

    [Fact]
    public void Dashes_are_measured_in_line_widths()
    {
        // 80 long, width 2: dashes of 8 and gaps of 4 make 6 full dashes and one of 8.
        var style = new StrokeStyle(2, Dashes: [4, 2]);

        Near.Equal(7 * 8 * 2, Area(Stroker.Stroke(Line((10, 50), (90, 50)), style, 1)), 0.1);
    }

    [Fact]
    public void A_dash_offset_starts_inside_of_the_pattern()
    {
        var style = new StrokeStyle(2, Dashes: [5, 5], DashOffset: 5);
        var bounds = Stroker.Stroke(Line((10, 50), (40, 50)), style, 1).ControlBounds(Matrix.Identity)!.Value;

        Near.Equal(20, bounds.Left, 1e-6);
        Near.Equal(30, bounds.Right, 1e-6);
    }

    [Fact]
    public void An_odd_number_of_dashes_is_repeated_the_other_way_round()
    {
        var style = new StrokeStyle(1, Dashes: [10, 5, 2]);

        // 10 on, 5 off, 2 on, 10 off, 5 on, 2 off.
        Near.Equal(17, Area(Stroker.Stroke(Line((10, 50), (44, 50)), style, 1)), 0.1);
    }

    [Fact]
    public void A_hair_fine_pattern_over_a_long_line_is_drawn_solid()
    {
        var style = new StrokeStyle(1, Dashes: [1e-5, 1e-5]);

        Near.Equal(80, Area(Stroker.Stroke(Line((10, 50), (90, 50)), style, 1)), 0.5);
    }

    [Fact]
    public void A_point_is_a_dot_with_round_caps_and_nothing_with_flat_ones()
    {
        var dot = Line((50, 50));

        Near.Equal(Math.PI * 16, Area(Stroker.Stroke(dot, new StrokeStyle(8, PenLineCap.Round), 1)), 0.5);
        Assert.True(Stroker.Stroke(dot, new StrokeStyle(8), 1).IsEmpty);
    }

    private static VectorPath Line(params (double X, double Y)[] points)
    {
        var path = new VectorPath();
        path.MoveTo(new Point(points[0].X, points[0].Y));
        foreach (var (x, y) in points[1..])
            path.LineTo(new Point(x, y));
        return path;
    }

    private static double Area(VectorPath path)
    {
        var scratch = DrawingScratch.Take();
        using var mask = ShapeFiller.MaskOf(scratch, path, Matrix.Identity, new PixelBounds(-20, -20, 140, 140));
        scratch.GiveBack();
        return mask.Cells.ToArray().Sum(cell => cell / 255.0);
    }
}
