using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Geometry;

public class GeometryTests
{
    [Fact]
    public void Bounds_are_those_of_the_curve_and_not_of_its_handles()
    {
        var arch = Picture.Geometry(g =>
        {
            g.BeginFigure(new Point(0, 0));
            g.CubicBezierTo(new Point(0, 40), new Point(100, 40), new Point(100, 0));
            g.EndFigure(false);
        });

        Near.Equal(30, arch.Bounds.Bottom, 0.05);
        Near.Equal(100, arch.Bounds.Right, 0.05);
    }

    [Fact]
    public void A_half_circle_by_its_ends_runs_through_its_top()
    {
        var arc = Picture.Geometry(g =>
        {
            g.BeginFigure(new Point(10, 50), false);
            g.ArcTo(new Point(90, 50), new Size(40, 40), 0, false, SweepDirection.Clockwise);
            g.EndFigure(false);
        });

        Near.Equal(10, arc.Bounds.Top, 0.05);
        Near.Equal(50, arc.Bounds.Bottom, 0.05);
        Near.Equal(Math.PI * 40, arc.ContourLength, 0.2);
    }

    [Theory]
    [InlineData(true, SweepDirection.Clockwise, -10, 50)]
    [InlineData(false, SweepDirection.Clockwise, 10, 21)]
    [InlineData(true, SweepDirection.CounterClockwise, 10, 50)]
    public void The_flags_of_an_arc_choose_among_the_four(bool isLarge, SweepDirection direction, double left, double right)
    {
        // A quarter or three quarters of a circle of radius 20 from (10,10) to (10,10) + a chord.
        var arc = Picture.Geometry(g =>
        {
            g.BeginFigure(new Point(10, 10), false);
            g.ArcTo(new Point(10, 10 + 20 * Math.Sqrt(2)), new Size(20, 20), 0, isLarge, direction);
            g.EndFigure(false);
        });
        var middle = 10 + (isLarge == (direction == SweepDirection.Clockwise) ? 1 : -1) * 20 / Math.Sqrt(2);

        Assert.InRange(arc.Bounds.Left, left - 45, right);
        var expectedRight = direction == SweepDirection.Clockwise ? middle + 20 : 10;
        Near.Equal(expectedRight, arc.Bounds.Right, 0.1);
    }

    [Fact]
    public void Inside_and_on_the_line_are_asked_apart()
    {
        var circle = Picture.Platform.CreateEllipseGeometry(new Rect(0, 0, 100, 100));
        var pen = Picture.Pen(Colors.Black, 4);

        Assert.True(circle.FillContains(new Point(50, 50)));
        Assert.False(circle.FillContains(new Point(10, 10)));
        Assert.True(circle.StrokeContains(pen, new Point(101.5, 50)));
        Assert.False(circle.StrokeContains(pen, new Point(50, 50)));
    }

    [Fact]
    public void A_figure_that_is_not_filled_is_only_part_of_the_line()
    {
        var geometry = Picture.Geometry(g =>
        {
            Square(g, 0, isFilled: true);
            Square(g, 50, isFilled: false);
        });

        Assert.True(geometry.FillContains(new Point(20, 20)));
        Assert.False(geometry.FillContains(new Point(70, 20)));
        Near.Equal(90, geometry.Bounds.Right, 1e-9);
        using var picture = new Picture(100, 50).Draw(c => c.DrawGeometry(Picture.Brush(Colors.Red), null, geometry));
        Near.Equal(1600, picture.Area(), 0.1);
    }

    [Fact]
    public void Render_bounds_hold_everything_that_is_drawn()
    {
        var spike = Picture.Geometry(g =>
        {
            g.BeginFigure(new Point(20, 40), false);
            g.LineTo(new Point(60, 50));
            g.LineTo(new Point(20, 60));
            g.EndFigure(false);
        });
        var pen = Picture.Pen(Colors.Black, 10);
        using var picture = new Picture(140, 100).Draw(c => c.DrawGeometry(null, pen, spike));
        var bounds = spike.GetRenderBounds(pen);

        Assert.True(picture.Alpha(75, 50) > 0);
        for (var y = 0; y < 100; y++)
        {
            for (var x = 0; x < 140; x++)
                Assert.True(picture.Alpha(x, y) == 0 || bounds.Contains(new Point(x + 0.5, y + 0.5)));
        }
    }

    [Fact]
    public void Points_and_tangents_along_the_line()
    {
        var line = Picture.Geometry(g =>
        {
            g.BeginFigure(new Point(0, 0), false);
            g.LineTo(new Point(30, 0));
            g.LineTo(new Point(30, 40));
            g.EndFigure(false);
        });

        Assert.Equal(70, line.ContourLength, 9);
        Assert.True(line.TryGetPointAndTangentAtDistance(50, out var point, out var tangent));
        Assert.Equal(new Point(30, 20), point);
        Assert.Equal(new Point(0, 1), tangent);
        Assert.False(line.TryGetPointAtDistance(71, out _));
        Assert.True(line.TryGetSegment(10, 40, true, out var piece));
        Assert.Equal(new Rect(10, 0, 20, 10), piece.Bounds);
    }

    [Fact]
    public void A_transformed_geometry_moves_its_fill_and_its_line()
    {
        var square = Picture.Platform.CreateRectangleGeometry(new Rect(0, 0, 10, 10));
        var moved = square.WithTransform(Matrix.CreateScale(2, 3) * Matrix.CreateTranslation(100, 0));

        Assert.Equal(new Rect(100, 0, 20, 30), moved.Bounds);
        Assert.True(moved.FillContains(new Point(115, 25)));
        Assert.Same(square, moved.SourceGeometry);
    }

    [Fact]
    public void A_stream_geometry_written_again_forgets_what_it_was()
    {
        var geometry = Picture.Platform.CreateStreamGeometry();
        using (var g = geometry.Open())
            Square(g, 0, isFilled: true);
        Assert.Equal(40, geometry.Bounds.Right);
        using (var g = geometry.Open())
            Square(g, 50, isFilled: true);

        Assert.Equal(50, geometry.Bounds.Left);
        Assert.False(geometry.FillContains(new Point(20, 20)));
        Assert.True(geometry.Clone().FillContains(new Point(70, 20)));
    }

    internal static void Square(IStreamGeometryContextImpl g, double left, bool isFilled)
    {
        g.BeginFigure(new Point(left, 0), isFilled);
        g.LineTo(new Point(left + 40, 0));
        g.LineTo(new Point(left + 40, 40));
        g.LineTo(new Point(left, 40));
        g.EndFigure(true);
    }
}
