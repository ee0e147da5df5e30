using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Tests.Sequencing;

/// <summary>Memory allocated by sequencing for each segment: the first access to new memory takes most of the time of a large drawing.</summary>
public class SequencingWeightTests
{
    private const int Squares = 2500;

    [Fact]
    public void Nesting_copies_no_contour_that_lies_in_no_other()
    {
        var segments = Grid();
        var contours = ContourChainer.Chain(segments, 0.01).Contours;
        var before = GC.GetAllocatedBytesForCurrentThread();
        var inside = ContourNesting.Find(contours, segments, 0.01);
        Assert.InRange((GC.GetAllocatedBytesForCurrentThread() - before) / segments.Length, 1, 100); // a copy of a segment alone takes 88
        Assert.All(inside, outer => Assert.Equal(-1, outer));
    }

    [Fact]
    public void The_search_for_the_nearest_start_keeps_no_box_for_each_joint()
    {
        var segments = Grid(sides: 40);
        var contours = ContourChainer.Chain(segments, 0.01).Contours;
        var inside = Enumerable.Repeat(-1, contours.Count).ToArray();
        var before = GC.GetAllocatedBytesForCurrentThread();
        var order = TravelOrder.Nearest(contours, segments, inside, DepthOrder.None, default, first: null);
        Assert.InRange((GC.GetAllocatedBytesForCurrentThread() - before) / segments.Length, 1, 60);
        Assert.Equal(contours.Count, order.Count);
    }

    [Fact]
    public void Each_stroke_begins_at_the_nearest_start_of_all_that_are_left()
    {
        var segments = Grid(sides: 37, squares: 60);
        var contours = ContourChainer.Chain(segments, 0.01).Contours;
        var order = TravelOrder.Nearest(contours, segments, Enumerable.Repeat(-1, contours.Count).ToArray(), DepthOrder.None, default, first: null);
        var (tool, left) = (default(Point2D), new List<StrokeEntry>());
        for (var i = 0; i < contours.Count; i++) StrokeEntry.AddAll(i, contours[i], segments, left);
        foreach (var entry in order)
        {
            Assert.Equal(left.MinBy(other => other.Place.DistanceTo(tool)), entry);
            left.RemoveAll(other => other.Contour == entry.Contour);
            tool = TravelOrder.EndOf(entry, contours[entry.Contour], segments);
        }
    }

    /// <summary>Regular polygons side by side, with separate boxes.</summary>
    private static Segment[] Grid(int sides = 4, int squares = Squares)
    {
        var segments = new Segment[sides * squares];
        for (var i = 0; i < squares; i++)
        {
            var centre = new Point2D(3.0 * (i % 50), 3.0 * (i / 50));
            for (var side = 0; side < sides; side++) segments[(i * sides) + side] = Segment.FromLine(Corner(centre, side, sides), Corner(centre, (side + 1) % sides, sides));
        }

        return segments;
    }

    private static Point2D Corner(Point2D centre, int corner, int corners) => centre + Vector2D.FromPolar(1.0, Angle.FromDegrees(360.0 * corner / corners));
}
