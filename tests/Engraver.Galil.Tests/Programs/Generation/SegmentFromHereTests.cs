using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs.Generation;

public class SegmentFromHereTests
{
    private static readonly AngleQuantum Quantum = new(1.0 / 65536.0);
    private static readonly CountsPoint Start = new(1000, 0);
    private static readonly VectorSegment Quarter = new(VectorSegmentKind.Arc, new CountsPoint(0, 1000), 1000, 0.0, 90.0, 7, 1570.8);

    [Fact]
    public void An_arc_ends_where_it_was_planned_though_it_begins_a_count_beside()
    {
        var here = new CountsPoint(1000, -2);
        var again = SegmentFromPosition.Adapt(Quarter, Start, here, Quantum);
        var end = new ArcPrediction(new Point2D(here.X, here.Y), again.Radius, again.ThetaDegrees, again.DeltaDegrees).End;

        Assert.True(end.DistanceTo(new Point2D(0, 1000)) < 1.0, $"ends at {end}");
        Assert.Equal((Quarter.End, Quarter.EntityIndex, Quarter.Radius), (again.End, again.EntityIndex, again.Radius));
        Assert.NotEqual(Quarter.DeltaDegrees, again.DeltaDegrees);
    }

    [Fact]
    public void From_where_it_was_planned_nothing_changes() => Assert.Equal(Quarter, SegmentFromPosition.Adapt(Quarter, Start, Start, Quantum));

    [Fact]
    public void An_arc_that_no_aim_keeps_within_a_count_stays_as_planned() => Assert.Equal(Quarter, SegmentFromPosition.Adapt(Quarter, Start, new CountsPoint(1090, 40), Quantum));
}
