using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing;

/// <summary>Ellipses and splines from the table to the toolpath: exact as long as possible, arcs in the last stage.</summary>
public class FreeCurveSequencingTests
{
    private static readonly RationalCurve HalfEllipse = FreeCurves.Ellipse(0, 0, 10, 0.5, 0, 0, 180).ToCurve();

    private static readonly RationalCurve Wave = FreeCurves.Spline(3, [new(10, 0), new(5, -6), new(-5, -6), new(-10, 0)], [1, 1, 1, 1]);

    [Fact]
    public void Rows_of_kinds_4_and_5_hold_the_ends_and_nothing_else()
    {
        using var csv = new StringWriter();
        EntityTableCsv.Write(Analysed(new DrawingBuilder().Free(HalfEllipse).Free(Wave).Build()), csv);

        Assert.Equal(
            "s0,s1,s2,s3,s4,s5,s6,s7,s8,s9,s10,s11,s12,s13,s14,s15\n4,10,0,0,-10,0,0,0,0,0,0,0,0,0,0,0\n5,10,0,0,-10,0,0,0,0,0,0,0,0,0,0,0\n",
            csv.ToString());
    }

    [Fact]
    public void Inches_become_millimetres()
    {
        var table = Analysed(new DrawingBuilder { Unit = new LengthUnit(1, "in", "INSUNITS", 25.4) }.Free(HalfEllipse).Build());

        Assert.Equal((254.0, -254.0), (table[0].StartPoint.X, table[0].EndPoint.X));
        Assert.Equal(25.4 * HalfEllipse.PlanLength, table[0].ToSegment().Length, 1e-9);
    }

    [Fact]
    public void An_ellipse_arc_and_a_spline_chain_to_one_closed_contour_and_one_is_turned_round()
    {
        var result = Sequenced(new DrawingBuilder().Free(HalfEllipse).Free(Wave));

        Assert.Equal((1, true, 2, 1), (result.Strokes.Count, result.Strokes[0].Closed, result.Segments, result.Reversed));
        var turned = result.Table[1];
        Assert.Equal((5, -10.0, 10.0), ((int)turned.Kind, turned.StartPoint.X, turned.EndPoint.X));
        Assert.Equal(turned.EndPoint, turned.ToSegment().PointAt(1.0));
    }

    [Fact]
    public void A_whole_ellipse_is_a_contour_by_itself_and_encloses_what_lies_in_it()
    {
        var result = Sequenced(new DrawingBuilder().Free(FreeCurves.Ellipse(0, 0, 10, 0.5, 0, 0, 360).ToCurve()).Circle(0, 0, 2).Circle(8, 4, 0.5).Line(10, 0, 20, 0));

        Assert.Equal(4, result.Strokes.Count);
        var ellipse = result.Strokes.Single(stroke => stroke.Moves[0].Segment.IsFreeCurve);
        Assert.Equal(ellipse.Index, result.Strokes.Single(stroke => stroke.Moves[0].Segment is { Kind: SegmentKind.Circle, Arc.Radius: 2.0 }).Inside);
        Assert.Equal(-1, result.Strokes.Single(stroke => stroke.Moves[0].Segment is { Kind: SegmentKind.Circle, Arc.Radius: 0.5 }).Inside);
    }

    [Fact]
    public void A_curve_drawn_twice_is_cut_once_and_one_that_only_shares_ends_and_middle_stays()
    {
        var (wide, narrow) = (FreeCurves.Ellipse(0, 0, 10, 0.5, 0, 0, 360).ToCurve(), FreeCurves.Ellipse(0, 0, 10, 0.3, 0, 0, 360).ToCurve());

        Assert.Equal(2, Sequenced(new DrawingBuilder().Free(wide).Free(narrow).Free(wide.Reversed())).Strokes.Count);
    }

    [Fact]
    public void The_toolpath_holds_arcs_with_the_entity_of_their_curve()
    {
        var sequenced = Sequenced(new DrawingBuilder().Line(30, 0, 40, 0).Free(HalfEllipse).Free(Wave));
        var path = ToolpathPlanner.Plan(sequenced, Point2D.Origin, 0.001);
        var moves = path.Strokes.SelectMany(stroke => stroke.Moves).ToList();

        Assert.DoesNotContain(moves, move => move.Segment.IsFreeCurve);
        Assert.Equal([0, 1, 2], moves.Select(move => move.EntityIndex).Distinct().Order());
        Assert.Equal(sequenced.PathLength, moves.Sum(move => move.Segment.Length), 1e-3);
    }

    private static SequencingResult Sequenced(DrawingBuilder builder)
    {
        var drawing = builder.Build();
        return Sequencer.Sequence(Analysed(drawing), drawing, UsualOptions.Sequencing);
    }

    private static EntityTable Analysed(Drawing drawing) => ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default));
}
