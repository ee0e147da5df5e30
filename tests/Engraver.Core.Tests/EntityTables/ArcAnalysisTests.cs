using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.EntityTables;

public class ArcAnalysisTests
{
    [Theory]
    [InlineData(0, 180, 180)]
    [InlineData(350, 10, 20)]
    [InlineData(10, 350, 340)]
    [InlineData(270, 360, 90)]
    [InlineData(270, 0, 90)]
    [InlineData(-30, 30, 60)]
    [InlineData(190, 260, 70)]
    public void The_rotation_angle_is_end_minus_start_across_zero_too(double start, double end, double rotation)
    {
        var row = Analysed(new DrawingBuilder().Arc(0, 0, 10, start, end))[0];

        Assert.Equal(rotation, row.SweepDegrees, 12);
    }

    [Fact]
    public void An_arc_keeps_the_angles_it_was_drawn_with()
    {
        var row = Analysed(new DrawingBuilder().Arc(0, 0, 10, 350, 10))[0];

        Assert.Equal((350.0, 10.0), (row[EntitySlot.StartAngle], row[EntitySlot.EndAngle]));
    }

    [Theory]
    [InlineData(0, 90, 110, 100, 100, 110)]
    [InlineData(90, 180, 100, 110, 90, 100)]
    [InlineData(180, 270, 90, 100, 100, 90)]
    [InlineData(270, 360, 100, 90, 110, 100)]
    public void Quadrant_points_are_exact(double start, double end, double x1, double y1, double x2, double y2)
    {
        var row = Analysed(new DrawingBuilder().Arc(100, 100, 10, start, end))[0];

        Assert.Equal(new Point2D(x1, y1), row.StartPoint);
        Assert.Equal(new Point2D(x2, y2), row.EndPoint);
    }

    [Fact]
    public void A_circle_waits_at_its_right_quadrant_point()
    {
        var row = Analysed(new DrawingBuilder().Circle(5, 7, 2))[0];

        Assert.Equal(new double[] { 2, 7, 7, 0, 7, 7, 0, 5, 7, 0, 2, 0, 360, 0, 0, 360 }, row.Slots.ToArray());
    }

    [Fact]
    public void A_clockwise_bulge_has_its_angles_in_travel_order_and_a_negative_rotation()
    {
        var half = new ArcSegment(new Point2D(0, 0), 10, Angle.FromDegrees(180), Angle.FromDegrees(-180));

        var row = Analysed(new DrawingBuilder().Curve(CurveType.LwPolyline, Segment.FromArc(half)))[0];

        Assert.Equal((180.0, 0.0, -180.0), (row[EntitySlot.StartAngle], row[EntitySlot.EndAngle], row.SweepDegrees));
        Assert.Equal((new Point2D(-10, 0), new Point2D(10, 0)), (row.StartPoint, row.EndPoint));
    }

    [Fact]
    public void Analysis_leaves_its_input_as_it_was()
    {
        var table = EntityTableBuilder.Build(SampleDrawings.PaperSample(), LayerSelection.Default);

        ArcAnalysis.Analyse(table);

        Assert.Equal(0.0, table[2][EntitySlot.Sweep]);
    }

    [Property]
    public Property Every_arc_ends_on_its_circle_and_keeps_its_way() =>
        Prop.ForAll(Arcs.Any, arc =>
        {
            var row = Analysed(new DrawingBuilder().Curve(CurveType.LwPolyline, Segment.FromArc(arc)))[0];
            var size = arc.Radius + arc.Centre.DistanceTo(Point2D.Origin);
            return Math.Abs(row.StartPoint.DistanceTo(arc.Centre) - arc.Radius) <= 1e-9 * size
                && Math.Abs(row.EndPoint.DistanceTo(arc.Centre) - arc.Radius) <= 1e-9 * size
                && row.EndPoint.IsNear(arc.EndPoint, 1e-9 * size)
                && row.SweepDegrees == arc.Sweep.Degrees;
        });

    [Property]
    public Property The_rotation_angle_of_a_drawn_arc_comes_from_its_angles_alone() =>
        Prop.ForAll(Arcs.CounterClockwise, arc =>
        {
            var row = Analysed(new DrawingBuilder().Curve(CurveType.Arc, Segment.FromArc(arc)))[0];
            return Math.Abs(row.SweepDegrees - arc.Sweep.Degrees) <= 1e-9;
        });

    private static EntityTable Analysed(DrawingBuilder drawing) => ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing.Build(), LayerSelection.Default));
}
