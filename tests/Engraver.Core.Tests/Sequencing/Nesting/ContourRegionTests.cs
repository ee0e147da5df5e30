using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Nesting;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Sequencing.Nesting;

public class ContourRegionTests
{
    /// <summary>The chord of two half circles is a diameter: a point on it is beside both arcs.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(90.0)]
    [InlineData(180.0)]
    [InlineData(270.0)]
    public void Points_on_the_chord_of_an_arc_are_inside(double turn)
    {
        var map = Transform2D.Rotate(Point2D.Origin, Angle.FromDegrees(turn));
        foreach (var clockwise in new[] { false, true })
        {
            var halves = Chain(true, (0, clockwise ? 1 : -1, clockwise ? -1 : 1), (0, clockwise ? -1 : 1, clockwise ? -1 : 1)).Segments;
            var region = new ContourRegion([.. halves.Select(segment => segment.Mapped(map))]);
            foreach (var place in new[] { new Point2D(0, 0), new Point2D(0, 0.5), new Point2D(0, -0.5), new Point2D(0.5, 0) })
            {
                Assert.True(region.Contains(map.Apply(place)), $"{place}");
                Assert.Equal(clockwise ? -1 : 1, region.Winding(map.Apply(place)));
            }
        }
    }

    /// <summary>Two arcs over the same chord, in opposite directions: a sickle.</summary>
    [Fact]
    public void Points_on_a_chord_outside_of_both_arcs_over_it_are_outside()
    {
        var sickle = new ContourRegion([.. Chain(true, (0, 1, 1), (1, 1, -0.4), (0.3, 1, 0), (0, 1, 0)).Segments]);
        Assert.Equal(0, sickle.Winding(new Point2D(0.5, 1)));
        Assert.Equal(1, sickle.Winding(new Point2D(0.5, 0.7)));
    }

    [Fact]
    public void The_winding_number_counts_turns_with_their_direction()
    {
        var twice = new ContourRegion([.. Chain(true, (2, 0, 1), (-1, 0, 1), (1, 0, 1), (-2, 0, 1)).Segments]);
        Assert.Equal(2, twice.Winding(new Point2D(0, 0.1)));
        Assert.Equal(1, twice.Winding(new Point2D(-1.2, -0.1)));
        Assert.Equal(0, twice.Winding(new Point2D(5, 0)));
        Assert.False(twice.Contains(new Point2D(0, 0.1)));
        var eight = new ContourRegion([.. Polygon((0, 0), (2, 2), (2, 0), (0, 2)).Segments]);
        Assert.Equal((-1, 1), (eight.Winding(new Point2D(1.8, 1)), eight.Winding(new Point2D(0.2, 1))));
    }
}
