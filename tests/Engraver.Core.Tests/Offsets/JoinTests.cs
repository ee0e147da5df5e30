using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.TestKit;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Mitres and bevels on the outside of corners.</summary>
public class JoinTests
{
    [Fact]
    public void A_mitred_rectangle_stays_a_rectangle()
    {
        var loop = Assert.Single(Offset(OffsetJoin.Mitre, 1, OffsetSide.Out, Rectangle(0, 0, 10, 4)).Loops);

        Assert.Equal((4, 0), (loop.Lines, loop.Arcs));
        Assert.Equal(72.0, loop.SignedArea, 9);
    }

    [Fact]
    public void A_bevelled_rectangle_has_eight_lines()
    {
        var loop = Assert.Single(Offset(OffsetJoin.Bevel, 1, OffsetSide.Out, Rectangle(0, 0, 10, 4)).Loops);

        Assert.Equal((8, 0), (loop.Lines, loop.Arcs));
        Assert.Equal(70.0, loop.SignedArea, 9);
    }

    /// <summary>The tip of a corner of 60 degrees is two distances away.</summary>
    [Theory]
    [InlineData(2.0, 3)]
    [InlineData(1.9, 6)]
    public void A_tip_beyond_the_limit_becomes_a_bevel(double limit, int lines)
    {
        var triangle = Polygon((0, 0), (10, 0), (5, 10 * Math.Sqrt(0.75)));
        var result = ContourOffset.Offset([triangle], 1, OffsetSide.Out, UsualOptions.OffsetWith(OffsetJoin.Mitre, limit));

        Assert.Equal(lines, Assert.Single(result.Loops).Lines);
    }

    [Fact]
    public void Before_an_arc_a_mitre_goes_on_along_its_tangent()
    {
        var half = Chain(true, (-5, 0, 0), (5, 0, 1)); // half a disc
        var loop = Assert.Single(Offset(OffsetJoin.Mitre, 1, OffsetSide.Out, half).Loops);

        Assert.Equal((3, 1), (loop.Lines, loop.Arcs));
        Assert.Equal((Math.PI * 18.0) + 12.0, loop.SignedArea, 9);
    }

    /// <summary>Two overlapping mitres give one loop: both enlarged squares less the square that they share.</summary>
    [Fact]
    public void Mitres_of_two_parts_that_overlap_become_one()
    {
        var loop = Assert.Single(Offset(OffsetJoin.Mitre, 1, OffsetSide.Out, Rectangle(0, 0, 5, 5), Rectangle(6.5, 6.5, 5, 5)).Loops);

        Assert.Equal((8, 0), (loop.Lines, loop.Arcs));
        Assert.Equal(49.0 + 49.0 - 0.25, loop.SignedArea, 9);
    }

    /// <summary>The mitre of a corner of 2 degrees is 57 distances long: it is not part of the deviation, which is measured beside the drawn
    /// segments.</summary>
    [Theory]
    [InlineData(OffsetJoin.Mitre)]
    [InlineData(OffsetJoin.Bevel)]
    public void Joins_are_no_deviation_and_all_else_is_measured(OffsetJoin join)
    {
        var needle = Polygon((0, 0), (10, -0.17455), (10, 0.17455));
        var result = ContourOffset.Offset([needle], 1, OffsetSide.Out, UsualOptions.OffsetWith(join, 100.0));

        Assert.InRange(result.MaxDeviation, 0.0, 1e-9);
        Assert.True(OffsetCheck.MaxDeviation([needle], [.. result.Loops.Select(loop => loop with { Segments = [.. loop.Segments.Select(segment => Segment.FromLine(Away(segment.Start), Away(segment.End)))] })], 1, OffsetSide.Out, UsualOptions.OffsetWith(join)) > 1e-4);

        static Point2D Away(Point2D place) => new(place.X * 1.001, place.Y * 1.001);
    }

    /// <summary>A circle that touches another with its seam: the part after the seam is not a corner.</summary>
    [Fact]
    public void A_seam_of_a_circle_is_no_mitre()
    {
        var result = Offset(OffsetJoin.Mitre, 0.5, OffsetSide.In, Rectangle(0, 0, 20, 20), Circle(8, 10, 2), Circle(12, 10, 2));

        Assert.Empty(result.Unresolved);
        Assert.Equal(2, result.Loops.Count);
    }

    [Theory]
    [InlineData(OffsetJoin.Mitre)]
    [InlineData(OffsetJoin.Bevel)]
    public void The_ends_of_an_open_contour_are_the_same_with_every_join(OffsetJoin join)
    {
        var loop = Assert.Single(Offset(join, 1, OffsetSide.Left, Line((0, 0), (10, 0), (10, 10))).Loops);

        Assert.Equal((2, 0), (loop.Lines, loop.Arcs));
        Assert.Equal(18.0, loop.Length, 9);
    }

    private static OffsetResult Offset(OffsetJoin join, double distance, OffsetSide side, params OffsetContour[] contours) =>
        ContourOffset.Offset(contours, distance, side, UsualOptions.OffsetWith(join));
}
