using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Dxf;

public class CurveTests
{
    [Theory]
    [InlineData(350.0, 10.0, 20.0)]
    [InlineData(0.0, 360.0, 360.0)]
    [InlineData(90.0, -270.0, 360.0)]
    [InlineData(45.0, 405.0000000001, 360.0)]
    [InlineData(10.0, 10.000001, 0.000001)]
    [InlineData(-90.0, 90.0, 180.0)]
    public void An_arc_runs_counter_clockwise_from_start_to_end(double start, double end, double sweep)
    {
        var drawing = Arc(start, end);

        Assert.Equal(sweep, drawing.Parts[0].F, 1e-9);
        Assert.Equal(sweep == 360.0 ? SegmentKind.Circle : SegmentKind.Arc, drawing.Parts[0].Kind);
        Assert.Equal(sweep == 360.0, drawing.Entities[0].Closed);
    }

    [Fact]
    public void An_arc_with_equal_angles_is_counted_and_reported_but_has_nothing_to_cut()
    {
        var drawing = Arc(45.0, 45.0);

        Assert.Equal((1, 0), (drawing.Entities.Count, drawing.Parts.Count));
        Assert.Contains("DXF0010", DxfReading.Ids(drawing));
    }

    [Fact]
    public void A_downward_extrusion_mirrors_x_exactly_and_turns_the_sense_of_an_arc()
    {
        var drawing = DxfReading.Entities((0, "ARC"), (10, 20), (20, 5), (40, 2), (50, 0), (51, 90), (230, -1));
        var arc = drawing.Parts[0];

        Assert.Equal((-20.0, 5.0, 2.0, 180.0, -90.0), (arc.A, arc.B, arc.D, arc.E, arc.F));
    }

    [Fact]
    public void Straight_parts_of_a_tilted_polyline_are_exact()
    {
        var drawing = DxfReading.Entities((0, "LWPOLYLINE"), (90, 2), (10, 0), (20, 0), (10, 10), (20, 0), (210, 1), (220, 0), (230, 0));
        var line = drawing.Parts[0];

        Assert.Equal(10.0, line.SpaceLength, 1e-12);
        Assert.Equal(10.0, line.E, 1e-12); // the own x axis of an extrusion along +x is the world's y axis
    }

    [Fact]
    public void A_bulge_counts_on_the_closing_part_only_when_the_polyline_is_closed()
    {
        (int, object)[] vertices = [(10, 0), (20, 0), (10, 10), (20, 0), (42, 1)];

        var open = DxfReading.Entities([(0, "LWPOLYLINE"), (70, 0), .. vertices]);
        var closed = DxfReading.Entities([(0, "LWPOLYLINE"), (70, 1), .. vertices]);

        Assert.Equal("Line", string.Join(' ', DxfReading.Parts(open).Select(part => part.Kind)));
        Assert.Equal("Line Arc", string.Join(' ', DxfReading.Parts(closed).Select(part => part.Kind)));
        Assert.True(closed.Entities[0].Closed);
        Assert.Equal(5.0 * Math.PI, closed.Parts[1].SpaceLength, 1e-12);
    }

    [Fact]
    public void Vertices_on_one_spot_have_no_part_between_them()
    {
        var drawing = DxfReading.Entities((0, "LWPOLYLINE"), (70, 1), (10, 0), (20, 0), (42, 1), (10, 0), (20, 0), (10, 5), (20, 0), (10, 0), (20, 0));

        Assert.Equal(2, drawing.Parts.Count);
    }

    [Fact]
    public void A_polyline_in_space_keeps_z_and_ignores_bulges()
    {
        var drawing = DxfReading.Entities(
            (0, "POLYLINE"), (66, 1), (70, 8), (0, "VERTEX"), (10, 0), (20, 0), (30, 0), (42, 1), (0, "VERTEX"), (10, 3), (20, 0), (30, 4), (0, "SEQEND"));

        Assert.Equal(5.0, drawing.Parts[0].SpaceLength, 1e-12);
        Assert.Equal(1, drawing.Balance.Read);
    }

    [Fact]
    public void A_flat_polyline_lies_at_its_elevation_and_leaves_out_the_frame_of_a_spline_fit()
    {
        var drawing = DxfReading.Entities(
            (0, "POLYLINE"), (70, 4), (10, 0), (20, 0), (30, 7), (0, "VERTEX"), (10, 0), (20, 0), (0, "VERTEX"), (10, 99), (20, 99), (70, 16), (0, "VERTEX"), (10, 3), (20, 4), (70, 8), (0, "SEQEND"));

        Assert.Equal((1, 5.0, 7.0), (drawing.Parts.Count, drawing.Parts[0].SpaceLength, drawing.Parts[0].C));
    }

    [Property]
    public bool Bulge_parts_meet_their_vertices(NormalFloat x, NormalFloat b)
    {
        var (endX, bulge) = (1.0 + Math.Abs(x.Get % 1e3), b.Get % 1e3);
        var segment = DxfReading.Entities((0, "LWPOLYLINE"), (10, 0.0), (20, 2.0), (42, bulge), (10, endX), (20, 0.0)).Parts[0].InPlan();
        return segment.Start.IsNear(new Point2D(0.0, 2.0), 1e-6 * endX) && segment.End.IsNear(new Point2D(endX, 0.0), 1e-6 * endX);
    }

    [Fact]
    public void Paper_space_and_what_belongs_to_it_is_not_read()
    {
        var drawing = DxfReading.Entities((0, "LINE"), (67, 1), (10, 0), (20, 0), (11, 1), (21, 0), (0, "POLYLINE"), (67, 1), (0, "VERTEX"), (10, 0), (20, 0), (0, "SEQEND"));

        Assert.Equal(0, drawing.Balance.Read);
    }

    [Fact]
    public void The_order_of_the_codes_does_not_matter()
    {
        var drawing = DxfReading.Entities((0, "LINE"), (31, 6), (21, 5), (11, 4), (30, 3), (20, 2), (10, 1), (5, "ff"), (8, "X"));
        var line = drawing.Parts[0];

        Assert.Equal((1.0, 2.0, 3.0, 4.0, 5.0, 6.0), (line.A, line.B, line.C, line.D, line.E, line.F));
        Assert.Equal("FF", drawing.SourceOf(0).Handle);
    }

    private static Drawing Arc(double start, double end) => DxfReading.Entities((0, "ARC"), (10, 0), (20, 0), (40, 10), (50, start), (51, end));
}
