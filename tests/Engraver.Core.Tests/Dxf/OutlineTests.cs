using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Construction that the operator selects for cutting (--cut).</summary>
public class OutlineTests
{
    [Fact]
    public void Without_the_choice_outlines_are_construction()
    {
        var drawing = DxfReading.Entities([.. OddDrawings.Hatch, .. OddDrawings.MLine, .. OddDrawings.Leader, .. OddDrawings.Solid, .. OddDrawings.Face]);

        Assert.Equal((5, 5, 0), (drawing.Balance.Read, drawing.Balance.Construction, drawing.Entities.Count));
    }

    [Theory]
    [InlineData(CutChoice.Hatch)]
    [InlineData(CutChoice.MLine)]
    [InlineData(CutChoice.Leader)]
    [InlineData(CutChoice.Solid)]
    public void Only_what_is_chosen_is_cut(CutChoice choice)
    {
        var drawing = Cut(choice, [.. OddDrawings.Hatch, .. OddDrawings.MLine, .. OddDrawings.Leader, .. OddDrawings.Solid]);

        Assert.Equal((4, 1, 3), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Balance.Construction));
        Assert.Equal(choice.ToString(), Assert.Single(DxfReading.Curves(drawing).Select(curve => curve.Type.ToString()).Distinct()));
    }

    [Fact]
    public void A_hatch_gives_each_loop_with_every_kind_of_edge()
    {
        var drawing = Cut(CutChoice.Hatch, OddDrawings.Hatch);
        var kinds = DxfReading.Curves(drawing).Select(curve => string.Join(' ', DxfReading.Parts(drawing).Skip(curve.FirstPart).Take(curve.PartCount).Select(part => part.Kind)));

        Assert.Equal(["Arc Line Line", "Line Arc Ellipse Spline"], kinds);
        AssertChained(drawing, 1, closed: true);
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void A_clockwise_edge_runs_from_minus_its_start_to_minus_its_end()
    {
        var drawing = Cut(CutChoice.Hatch, [(0, "HATCH"), (91, 1), (92, 1), (93, 1), (72, 2), (10, 0), (20, 0), (40, 5), (50, 270), (51, 360), (73, 0), (97, 0), (75, 0)]);
        var arc = drawing.Parts[0].InPlan();

        Assert.True(arc.Start.IsNear(new Point2D(0, 5), 1e-12) && arc.End.IsNear(new Point2D(5, 0), 1e-12) && arc.PointAt(0.5).IsNear(new Point2D(5 * Math.Sqrt(0.5), 5 * Math.Sqrt(0.5)), 1e-12));
    }

    [Fact]
    public void The_angles_of_an_elliptical_edge_are_seen_angles_so_that_edges_meet()
    {
        // From a boundary drawn in a CAD program: the previous line ends at the start of the ellipse, the next line starts at its end.
        var drawing = Cut(CutChoice.Hatch, [(0, "HATCH"), (91, 1), (92, 1), (93, 1), (72, 3), (10, 49.64089977339618), (20, 36.43095770602131), (11, 16.69099826506408), (21, 6.96203799241026), (40, 0.173450304570581), (50, 348.7055398636587), (51, 472.8737032507014), (73, 1), (97, 0), (75, 0)]);
        var edge = drawing.SegmentOf(drawing.Parts[0]);

        Assert.True(edge.Start.IsNear(new Point2D(61.497054318147256, 38.81021154906709), 1e-9), $"{edge.Start}");
        Assert.True(edge.End.IsNear(new Point2D(47.218453835850994, 38.81021154906708), 1e-9), $"{edge.End}");
    }

    [Fact]
    public void A_hatch_in_a_mirrored_block_and_under_a_negative_extrusion_lies_where_it_is_drawn()
    {
        (int, object)[] hatch = [(0, "HATCH"), (10, 0), (20, 0), (30, 2), (210, 0), (220, 0), (230, -1), (91, 1), (92, 2), (72, 0), (73, 1), (93, 3), (10, 1), (20, 0), (10, 4), (20, 0), (10, 4), (20, 4), (97, 0), (75, 0)];
        var direct = Cut(CutChoice.Hatch, hatch);
        var inserted = DxfReading.Of(
            new DxfText().Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), .. hatch, (0, "ENDBLK")]).Section("ENTITIES", (0, "INSERT"), (2, "B"), (10, 100), (20, 0), (41, -1)).End().ToAscii(),
            new DxfReadOptions(Cut: CutChoice.Hatch));

        Assert.Equal(new Bounds2D(-4, 0, -1, 4), DrawingSummary.From(direct).Bounds);
        Assert.Equal(new Bounds2D(101, 0, 104, 4), DrawingSummary.From(inserted).Bounds);
        Assert.Equal((12.0, 1), (DrawingSummary.From(inserted).Length.Total, inserted.Balance.Cut));
    }

    /// <summary>One vertex has no joint with others; additional elements of a vertex compared with its neighbour (damage) are ignored.</summary>
    [Theory]
    [InlineData(1, 2, 2, 0)]
    [InlineData(2, 7, 2, 2)]
    [InlineData(2, 2, 7, 2)]
    public void A_multiline_that_lacks_vertices_or_elements_is_cut_as_far_as_it_goes(int vertices, int first, int last, int arcs)
    {
        (int, object)[] Vertex(int number, int elements) =>
            [(11, 10.0 * number), (21, 0.0), (12, 1.0), (22, 0.0), (13, 0.0), (23, 1.0), .. Enumerable.Range(0, elements).SelectMany(element => ((int, object)[])[(74, 1), (41, element), (75, 0)])];
        (int, object)[] line = [(0, "MLINE"), (2, "Standard"), (40, 1.0), (70, 0), (71, 0), (72, vertices), (73, 2), .. Vertex(0, first), .. (vertices > 1 ? Vertex(1, last) : [])];

        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", line).Section("OBJECTS", (0, "MLINESTYLE"), (2, "Standard"), (70, 2 + 64 + 1024 + 32 + 512)).End().ToAscii(), new DxfReadOptions(Cut: CutChoice.MLine));

        Assert.Equal(arcs, DxfReading.Parts(drawing).Count(part => part.Kind == SegmentKind.Arc));
    }

    [Fact]
    public void A_multiline_gives_each_element_and_the_caps_of_its_style()
    {
        var plain = Cut(CutChoice.MLine, OddDrawings.MLine);
        var capped = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", OddDrawings.MLine).Section("OBJECTS", (0, "MLINESTYLE"), (2, "STANDARD"), (70, 16 + 1024)).End().ToAscii(), new DxfReadOptions(Cut: CutChoice.MLine));

        Assert.Equal("0,1>10,1 0,-1>10,-1", Lines(plain));
        Assert.Equal((4, 1), (capped.Entities.Count, capped.Balance.Cut));
        Assert.Equal((0.0, 11.0), (DrawingSummary.From(capped).Bounds!.Value.MinX, DrawingSummary.From(capped).Bounds!.Value.MaxX)); // the round cap projects at the end
    }

    [Fact]
    public void A_closed_multiline_comes_back_to_its_first_vertex_and_has_no_caps()
    {
        static (int, object)[] Vertex(double x, double y, double mx, double my) => [(11, x), (21, y), (12, 1), (22, 0), (13, mx), (23, my), (74, 1), (41, 0), (75, 0), (74, 1), (41, 1), (75, 0)];
        (int, object)[] closed = [(0, "MLINE"), (2, "Standard"), (71, 3), (72, 3), (73, 2), .. Vertex(0, 0, -1, -1), .. Vertex(10, 0, 1, -1), .. Vertex(5, 9, 0, 1)];
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 4).Section("ENTITIES", closed).Section("OBJECTS", (0, "MLINESTYLE"), (2, "Standard"), (70, 272)).End().ToAscii(), new DxfReadOptions(Cut: CutChoice.MLine));

        Assert.Equal([3, 3], DxfReading.Curves(drawing).Select(curve => curve.PartCount));
        Assert.All(DxfReading.Curves(drawing), curve => Assert.True(curve.Closed));
        AssertChained(drawing, 0, closed: true);
    }

    [Fact]
    public void A_leader_is_its_line_or_the_spline_through_its_vertices()
    {
        var straight = Cut(CutChoice.Leader, OddDrawings.Leader);
        var curved = Cut(CutChoice.Leader, [.. OddDrawings.Leader.Select(pair => pair.Code == 72 ? (72, (object)1) : pair)]);

        Assert.Equal("0,0>3,4 3,4>8,4", Lines(straight));
        Assert.Equal(SegmentKind.Spline, Assert.Single(DxfReading.Parts(curved)).Kind);
        Assert.True(curved.SegmentOf(curved.Parts[0]).DistanceTo(new Point2D(3, 4)) < 1e-9);
    }

    [Fact]
    public void A_helix_is_its_spline_seen_from_above()
    {
        (int, object)[] helix = [(0, "HELIX"), (100, "AcDbSpline"), .. OddDrawings.Spline[1..], (100, "AcDbHelix"), (90, 29), (10, 77), (20, 77), (11, 78), (21, 77), (40, 0.5), (41, 3)];
        var drawing = Cut(CutChoice.Helix, helix);

        var spline = DxfReading.Entities(OddDrawings.Spline);
        Assert.Equal((CurveType.Helix, DrawingSummary.From(spline).Length.Total), (drawing.Entities[0].Type, DrawingSummary.From(drawing).Length.Total));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void A_solid_runs_1_2_4_3_and_a_face_leaves_its_invisible_edges_out()
    {
        Assert.Equal("0,0>5,0 5,0>5,5 5,5>0,5 0,5>0,0", Lines(Cut(CutChoice.Solid, OddDrawings.Solid)));
        Assert.Equal("0,0>5,0 5,5>0,5 0,5>0,0", Lines(Cut(CutChoice.Solid, OddDrawings.Face)));
        Assert.Equal("0,0>5,0 5,0>0,5 0,5>0,0", Lines(Cut(CutChoice.Solid, [(0, "TRACE"), (10, 0), (20, 0), (11, 5), (21, 0), (12, 0), (22, 5), (13, 0), (23, 5)])));
    }

    [Fact]
    public void An_outline_that_holds_nothing_is_refused_by_name_and_harms_no_other()
    {
        var drawing = Cut((CutChoice)31, [(0, "HATCH"), (5, "2F"), (91, 1), (92, 1), (93, 1), (72, 9), (0, "SOLID"), (0, "HELIX"), (5, "30"), .. OddDrawings.Circle]);

        Assert.Equal((4, 1, 3), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Balance.Refused.Count));
        Assert.Equal(["DXF0038", "DXF0038", "DXF0034"], drawing.Balance.Refused.Select(refused => refused.DiagnosticId));
        Assert.Contains("edge type 9", drawing.Balance.Refused[0].Reason, StringComparison.Ordinal);
    }

    private static Drawing Cut(CutChoice choice, params ReadOnlySpan<(int Code, object Value)> entities) => DxfReading.Of(DxfText.WithEntities(entities).ToAscii(), new DxfReadOptions(Cut: choice));

    private static string Lines(Drawing drawing) => string.Join(' ', DxfReading.Parts(drawing).Select(part => $"{part.A:0.#},{part.B:0.#}>{part.D:0.#},{part.E:0.#}"));

    private static void AssertChained(Drawing drawing, int curve, bool closed)
    {
        var segments = DrawingPick.Segments(drawing, curve).ToList();
        for (var i = closed ? 0 : 1; i < segments.Count; i++) Assert.True(segments[(i + segments.Count - 1) % segments.Count].End.IsNear(segments[i].Start, 1e-9), $"part {i}: {segments[i].Start}");
    }
}
