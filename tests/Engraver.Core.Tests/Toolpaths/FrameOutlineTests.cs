using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Tests.Toolpaths;

/// <summary>The outline that a machine follows before a job.</summary>
public class FrameOutlineTests
{
    private static readonly Segment s_circle = Segment.FromArc(new ArcSegment(new Point2D(40, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(360)));

    [Fact]
    public void The_rectangle_goes_round_everything_that_is_cut_once()
    {
        var round = FrameOutline.Rectangle(Path(Segment.FromLine(new(0, 0), new(20, 0)), s_circle));

        Assert.Equal([new(0, -5), new(45, -5), new(45, 5), new(0, 5)], Corners(round));
        Assert.Equal(round.Strokes[0].Start, round.Strokes[0].End);
    }

    [Fact]
    public void The_hull_holds_every_arc_and_is_hardly_wider()
    {
        var corners = Corners(FrameOutline.Hull(Path(Segment.FromLine(new(0, 0), new(20, 0)), s_circle)));

        Assert.Equal(new Point2D(0, 0), corners[0]);
        Assert.All(corners.Skip(1), corner => Assert.InRange(corner.DistanceTo(new Point2D(40, 0)), 5.0, 5.005));
        for (var degrees = 0; degrees < 360; degrees++) Assert.True(Holds(corners, s_circle.PointAt(degrees / 360.0)));
        Assert.False(Holds(corners, new Point2D(20, 5)));
    }

    [Fact]
    public void A_line_along_an_axis_is_gone_along_there_and_back_and_nothing_gives_nothing()
    {
        var path = Path(Segment.FromLine(new(1, 2), new(9, 2)));

        foreach (var round in new[] { FrameOutline.Rectangle(path), FrameOutline.Hull(path) }) Assert.Equal([new(1, 2), new(9, 2)], Corners(round));
        Assert.Empty(FrameOutline.Rectangle(path with { Strokes = [] }).Strokes);
        Assert.Empty(FrameOutline.Hull(path with { Strokes = [] }).Strokes);
    }

    private static Toolpath Path(params Segment[] segments) => new(default, [.. segments.Select((segment, i) => new ToolpathStroke(i, false, [new StrokeMove(segment, i)]))]);

    private static List<Point2D> Corners(Toolpath round) => [.. Assert.Single(round.Strokes).Moves.Select(move => move.Segment.Start)];

    private static bool Holds(List<Point2D> corners, Point2D place)
    {
        for (var i = 0; i < corners.Count; i++)
        {
            var (from, to) = (corners[i], corners[(i + 1) % corners.Count]);
            if (((to.X - from.X) * (place.Y - from.Y)) - ((to.Y - from.Y) * (place.X - from.X)) < -1e-9) return false;
        }

        return true;
    }
}
