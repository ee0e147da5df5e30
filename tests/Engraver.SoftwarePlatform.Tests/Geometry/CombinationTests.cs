using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Geometry;

public class CombinationTests
{
    private static readonly IGeometryImpl s_left = Picture.Platform.CreateEllipseGeometry(new Rect(10, 10, 60, 60));
    private static readonly IGeometryImpl s_right = Picture.Platform.CreateEllipseGeometry(new Rect(40, 10, 60, 60));

    /// <summary>Two circles of radius 30, centres 30 apart, have this in common.</summary>
    private static readonly double s_lens = 2 * 900 * Math.Acos(0.5) - 15 * Math.Sqrt(4 * 900 - 900);

    [Fact]
    public void Four_combinations_of_two_circles_have_the_areas_of_the_lens_formula()
    {
        var circle = Math.PI * 900;

        Near.Equal(s_lens, Area(GeometryCombineMode.Intersect), 3);
        Near.Equal(2 * circle - s_lens, Area(GeometryCombineMode.Union), 4);
        Near.Equal(2 * circle - 2 * s_lens, Area(GeometryCombineMode.Xor), 5);
        Near.Equal(circle - s_lens, Area(GeometryCombineMode.Exclude), 4);
    }

    [Fact]
    public void The_result_is_one_outline_without_lines_inside()
    {
        var union = Picture.Platform.CreateCombinedGeometry(
            GeometryCombineMode.Union,
            Picture.Platform.CreateRectangleGeometry(new Rect(10, 10, 40, 20)),
            Picture.Platform.CreateRectangleGeometry(new Rect(30, 20, 40, 20)));

        // An outline of two overlapping rectangles: the box's circumference.
        Near.Equal(2 * (60 + 30), union.ContourLength, 1e-6);
    }

    [Fact]
    public void A_hole_is_cut_out_of_the_middle()
    {
        var frame = Picture.Platform.CreateCombinedGeometry(
            GeometryCombineMode.Exclude,
            Picture.Platform.CreateRectangleGeometry(new Rect(0, 0, 60, 60)),
            Picture.Platform.CreateRectangleGeometry(new Rect(20, 20, 20, 20)));

        Assert.False(frame.FillContains(new Point(30, 30)));
        Assert.True(frame.FillContains(new Point(10, 30)));
        Near.Equal(4 * 60 + 4 * 20, frame.ContourLength, 1e-6);
        Near.Equal(3600 - 400, Area(frame), 0.5);
    }

    [Fact]
    public void Shapes_apart_from_each_other_have_no_intersection()
    {
        var far = Picture.Platform.CreateRectangleGeometry(new Rect(500, 500, 10, 10));

        Assert.Null(s_left.Intersect(far));
        Near.Equal(s_lens, Area(s_left.Intersect(s_right)!), 3);
    }

    private static double Area(GeometryCombineMode mode) => Area(Picture.Platform.CreateCombinedGeometry(mode, s_left, s_right));

    private static double Area(IGeometryImpl geometry)
    {
        using var picture = new Picture(120, 100).Draw(c => c.DrawGeometry(Picture.Brush(Colors.Black), null, geometry));
        return picture.Area();
    }
}
