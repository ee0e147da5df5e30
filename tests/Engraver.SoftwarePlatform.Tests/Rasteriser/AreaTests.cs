using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Rasteriser;

/// <summary>Compares covered areas with their geometric values.</summary>
public class AreaTests
{
    private static readonly PixelBounds s_page = new(0, 0, 200, 200);

    /// <summary>Curves are drawn as chords that are at most 0.02 pixels inside of them; on average two thirds of that.</summary>
    private const double ErrorPerPixelOfCurve = 0.02;

    /// <summary>A cell has a resolution of 1/255 of its pixel, so that the error grows with the length of the border.</summary>
    private const double ErrorPerPixelOfBorder = 1.0 / 255;

    [Fact]
    public void Triangles_anywhere_cover_half_of_the_cross_product_of_their_sides()
    {
        var random = new Random(5);
        for (var round = 0; round < 200; round++)
        {
            var corners = Enumerable.Range(0, 3).Select(_ => new Point(random.NextDouble() * 200, random.NextDouble() * 200)).ToArray();
            var (a, b) = (corners[1] - corners[0], corners[2] - corners[0]);
            var border = Distance(corners[0], corners[1]) + Distance(corners[1], corners[2]) + Distance(corners[2], corners[0]);

            Near.Equal(Math.Abs((a.X * b.Y) - (a.Y * b.X)) / 2, Area(Polygon(FillRule.NonZero, corners)), 0.05 + (2 * border * ErrorPerPixelOfBorder));
        }
    }

    [Fact]
    public void What_is_cut_off_by_the_page_on_any_side_does_not_count()
    {
        var square = Polygon(FillRule.NonZero, new Point(-50, -50), new Point(250, -50), new Point(250, 250), new Point(-50, 250));
        Near.Equal(200 * 200, Area(square), 0.01);

        foreach (var (x, y) in new[] { (-40.5, 20.0), (170.0, 20.0), (20.0, -40.5), (20.0, 170.0), (-40.5, 170.0) })
        {
            var moved = Polygon(FillRule.NonZero, new Point(x, y), new Point(x + 60, y), new Point(x + 60, y + 60), new Point(x, y + 60));
            Near.Equal(Seen(x) * Seen(y), Area(moved), 0.3);
        }

        static double Seen(double from) => Math.Min(200, from + 60) - Math.Max(0, from);
    }

    [Fact]
    public void Turned_and_scaled_a_shape_covers_its_area_times_the_determinant()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddEllipse(new Rect(-20, -10, 40, 20));
        foreach (var degrees in new[] { 0, 17, 45, 90, 133 })
        {
            var map = Matrix.CreateScale(1.5, 2.5) * Matrix.CreateRotation(degrees * Math.PI / 180) * Matrix.CreateTranslation(100.3, 99.6);
            Near.Equal(Math.PI * 20 * 10 * 1.5 * 2.5, Area(path, map), 2.0);
        }
    }

    /// <summary>The pentagon in the middle of a five-pointed star is enclosed twice.</summary>
    [Fact]
    public void A_star_has_a_hole_only_by_even_odd()
    {
        var tips = Enumerable.Range(0, 5).Select(i => new Point(100 + (80 * Math.Sin(i * 4 * Math.PI / 5)), 100 - (80 * Math.Cos(i * 4 * Math.PI / 5)))).ToArray();
        var inner = 80 * Math.Cos(2 * Math.PI / 5) / Math.Cos(Math.PI / 5);
        var pentagon = 2.5 * inner * inner * Math.Sin(2 * Math.PI / 5);
        var whole = 5 * 80 * inner * Math.Sin(Math.PI / 5);

        Near.Equal(whole, Area(Polygon(FillRule.NonZero, tips)), 4);
        Near.Equal(whole - pentagon, Area(Polygon(FillRule.EvenOdd, tips)), 4);
    }

    [Fact]
    public void Two_shapes_of_opposite_sense_leave_nothing_where_both_are()
    {
        var path = Polygon(FillRule.NonZero, new Point(10, 10), new Point(110, 10), new Point(110, 110), new Point(10, 110));
        path.Append(Polygon(FillRule.NonZero, new Point(60, 60), new Point(60, 160), new Point(160, 160), new Point(160, 60)), Matrix.Identity);

        Near.Equal((2 * 100 * 100) - (2 * 50 * 50), Area(path), 0.1);
    }

    /// <summary>Cubic with handles straight up: the area under it is 3/4 of height times width (Simpson's rule on y dx).</summary>
    [Fact]
    public void Under_an_arch_of_one_cubic_lies_its_area()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(20, 150));
        path.CubicTo(new Point(20, 50), new Point(180, 50), new Point(180, 150));
        path.Close();
        // x(t) = 20 + 160 (3t^2 - 2t^3), height(t) = 300 t (1 - t): the integral of height dx is 160 * 300 * 6 * 1/30.
        Near.Equal(160.0 * 300 * 6 / 30, Area(path), 230 * ErrorPerPixelOfCurve);
    }

    [Fact]
    public void A_quadratic_covers_two_thirds_of_its_triangle()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(20, 150));
        path.QuadraticTo(new Point(100, 30), new Point(180, 150));
        path.Close();

        Near.Equal(2.0 / 3 * 160 * 120 / 2, Area(path), 200 * ErrorPerPixelOfCurve);
    }

    /// <summary>An arc with a radius that cannot reach is a half circle over its chord (SVG 1.1, F.6.6).</summary>
    [Theory]
    [InlineData(5)]
    [InlineData(50)]
    public void An_arc_of_too_small_a_radius_grows_to_a_half_circle(double radius)
    {
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(50, 100));
        path.ArcTo(new Point(150, 100), new Size(radius, radius), 0, false, true);
        path.Close();

        Near.Equal(Math.PI * 50 * 50 / 2, Area(path), 1.5);
    }

    [Fact]
    public void An_arc_without_a_radius_is_a_line_and_one_without_a_way_is_nothing()
    {
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(50, 100));
        path.ArcTo(new Point(150, 100), new Size(0, 30), 0, true, true);
        path.LineTo(new Point(150, 150));
        path.ArcTo(new Point(150, 150), new Size(30, 30), 0, true, true);
        path.Close();

        Near.Equal(100 * 50 / 2.0, Area(path), 1);
    }

    /// <summary>Half of a turned ellipse: its chord runs through the middle.</summary>
    [Fact]
    public void A_turned_elliptical_arc_covers_half_of_its_ellipse()
    {
        var (sin, cos) = Math.SinCos(30 * Math.PI / 180);
        var path = new VectorPath(FillRule.NonZero);
        path.MoveTo(new Point(100 - (60 * cos), 100 - (60 * sin)));
        path.ArcTo(new Point(100 + (60 * cos), 100 + (60 * sin)), new Size(60, 25), 30, false, true);
        path.Close();

        Near.Equal(Math.PI * 60 * 25 / 2, Area(path), 2);
    }

    private static VectorPath Polygon(FillRule rule, params Point[] corners)
    {
        var path = new VectorPath(rule);
        path.MoveTo(corners[0]);
        foreach (var corner in corners[1..])
            path.LineTo(corner);
        path.Close();
        return path;
    }

    private static double Distance(Point a, Point b) => Point.Distance(a, b);

    private static double Area(VectorPath path) => Area(path, Matrix.Identity);

    private static double Area(VectorPath path, Matrix transform)
    {
        var scratch = DrawingScratch.Take();
        using var mask = ShapeFiller.MaskOf(scratch, path, transform, s_page);
        scratch.GiveBack();
        return mask.Cells.ToArray().Sum(cell => cell / 255.0);
    }
}
