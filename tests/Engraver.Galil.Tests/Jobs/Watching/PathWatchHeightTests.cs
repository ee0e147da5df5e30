using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Watching;

namespace Engraver.Galil.Tests.Jobs.Watching;

/// <summary>If an axis moves the tool, a polled position is compared with the path in height as well.</summary>
public class PathWatchHeightTests
{
    private static readonly VectorSegment[] s_slope = [new(VectorSegmentKind.Line, new(10000, 0, -2000), 0, 0, 0, 3, Math.Sqrt(1.04e8))];

    [Theory]
    [InlineData(5000, -1000, false)]
    [InlineData(5000, -1005, false)] // read a sample later: 20 counts along the path are 3.9 down
    [InlineData(5000, -900, true)]
    [InlineData(5000, -1100, true)]
    public void A_slope_is_left_by_who_is_too_high_or_too_deep(int x, int z, bool leaves)
    {
        var watch = new PathWatch(default, s_slope, 20000, 0.001, followsHeight: true);

        Assert.Equal(leaves, watch.Check(0, new CountsPoint(x, 0, z)) is not null);
    }

    [Fact]
    public void The_end_is_compared_in_height_and_on_a_machine_that_switches_its_tool_it_is_not()
    {
        Assert.NotNull(new PathWatch(default, s_slope, 20000, 0.001, followsHeight: true).LookAtEnd(new CountsPoint(10000, 0, -1990)));
        Assert.Null(new PathWatch(default, s_slope, 20000, 0.001, followsHeight: true).LookAtEnd(new CountsPoint(10000, 0, -1999)));
        Assert.Null(new PathWatch(default, s_slope, 20000, 0.001).LookAtEnd(new CountsPoint(10000, 0, 777)));
    }
}
