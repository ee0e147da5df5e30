using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Tests.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Geometry;

/// <summary>Parts of a line between two distances along it.</summary>
public class PieceTests
{
    [Theory]
    [InlineData(0, 70, 70)]
    [InlineData(10, 50, 40)]
    [InlineData(-5, 20, 20)]
    [InlineData(60, 500, 10)]
    public void A_piece_is_as_long_as_asked_as_far_as_there_is_line(double from, double to, double length)
    {
        Assert.True(Corner().TryGetSegment(from, to, true, out var piece));

        Assert.Equal(length, piece.ContourLength, 9);
    }

    [Fact]
    public void A_piece_around_a_corner_keeps_the_corner()
    {
        Assert.True(Corner().TryGetSegment(20, 50, true, out var piece));

        Assert.Equal(new Rect(20, 0, 10, 20), piece.Bounds);
        Assert.True(piece.TryGetPointAtDistance(10, out var corner));
        Assert.Equal(new Point(30, 0), corner);
    }

    /// <summary>Between two figures nothing is drawn.</summary>
    [Fact]
    public void A_piece_over_two_figures_has_a_gap()
    {
        var two = Picture.Geometry(g =>
        {
            Line(g, new Point(0, 0), new Point(10, 0));
            Line(g, new Point(100, 0), new Point(110, 0));
        });
        Assert.True(two.TryGetSegment(5, 15, true, out var piece));

        Assert.Equal(10, piece.ContourLength, 9);
        Assert.True(piece.StrokeContains(Picture.Pen(Colors.Black, 2), new Point(102, 0)));
        Assert.False(piece.StrokeContains(Picture.Pen(Colors.Black, 2), new Point(50, 0)));
    }

    [Fact]
    public void Beyond_the_end_there_is_no_point()
    {
        Assert.False(Corner().TryGetPointAtDistance(70.5, out _));
        Assert.True(Corner().TryGetPointAndTangentAtDistance(0, out var point, out var tangent));
        Assert.Equal((new Point(0, 0), new Point(1, 0)), (point, tangent));
    }

    private static IGeometryImpl Corner() => Picture.Geometry(g =>
    {
        g.BeginFigure(new Point(0, 0), false);
        g.LineTo(new Point(30, 0));
        g.LineTo(new Point(30, 40));
        g.EndFigure(false);
    });

    private static void Line(IStreamGeometryContextImpl g, Point from, Point to)
    {
        g.BeginFigure(from, false);
        g.LineTo(to);
        g.EndFigure(false);
    }
}
