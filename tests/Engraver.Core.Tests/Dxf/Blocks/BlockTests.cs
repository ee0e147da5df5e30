using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Dxf.Blocks;

public class BlockTests
{
    private static readonly (int, object)[] LineAndArc =
    [
        (0, "LINE"), (8, "0"), (10, 1), (20, 1), (11, 11), (21, 1),
        (0, "ARC"), (8, "CUT"), (10, 11), (20, 6), (40, 5), (50, 270), (51, 90),
    ];

    [Property]
    public Property Exploding_a_nested_insert_gives_what_reading_and_transforming_gives() =>
        Prop.ForAll(Inserts(), Inserts(), (inner, outer) =>
        {
            var nested = Drawing(
                [.. Block("A", 1.0, 1.0, LineAndArc), .. Block("B", -2.0, 3.0, inner.Pairs("A"))],
                outer.Pairs("B"));
            for (var i = 0; i < 2; i++)
            {
                var direct = (i == 0 ? Segment.FromLine(new Point2D(1, 1), new Point2D(11, 1)) : Segment.FromArc(new ArcSegment(new Point2D(11, 6), 5.0, Angle.FromDegrees(270), Angle.FromDegrees(180))));
                var segment = nested.Parts[i].InPlan();
                Assert.Equal(direct.Kind, segment.Kind);
                foreach (var fraction in new[] { 0.0, 0.3, 1.0 })
                {
                    var expected = outer.Map(inner.Map(direct.PointAt(fraction), 1.0, 1.0), -2.0, 3.0);
                    Assert.True(expected.IsNear(segment.PointAt(fraction), 1e-6), $"{expected} {segment.PointAt(fraction)}");
                }
            }
        });

    [Fact]
    public void An_array_is_turned_by_the_rotation_and_not_stretched_by_the_scale()
    {
        var drawing = Drawing(
            Block("A", 0, 0, [(0, "CIRCLE"), (10, 0), (20, 0), (40, 1)]),
            [(0, "INSERT"), (2, "A"), (10, 100), (20, 0), (41, 2), (42, 2), (50, 90), (70, 2), (71, 3), (44, 10), (45, 20)]);

        Assert.Equal("100,0 100,10 80,0 80,10 60,0 60,10", string.Join(' ', DxfReading.Parts(drawing).Select(part => $"{part.A:0},{part.B:0}")));
        Assert.All(DxfReading.Parts(drawing), part => Assert.Equal(2.0, part.D));
    }

    [Fact]
    public void A_mirrored_arc_stays_an_arc_and_runs_the_other_way()
    {
        var arc = Drawing(Block("A", 0, 0, [(0, "ARC"), (10, 5), (20, 0), (40, 2), (50, 0), (51, 90)]), [(0, "INSERT"), (2, "A"), (10, 0), (20, 0), (41, -3), (42, 3)]).Parts[0];

        Assert.Equal((-15.0, 6.0, 180.0, -90.0), (arc.A, arc.D, arc.E, arc.F));
    }

    [Fact]
    public void Under_unequal_scale_lines_stay_exact_and_arcs_become_ellipses()
    {
        var drawing = Drawing(Block("A", 0, 0, LineAndArc), [(0, "INSERT"), (2, "A"), (10, 0), (20, 0), (41, 2), (42, 3), (70, 4), (44, 50)]);

        Assert.Equal((8, 22.0, 3.0), (drawing.Entities.Count, drawing.Parts[0].D, drawing.Parts[0].E));
        Assert.Equal(4, DxfReading.Parts(drawing).Count(part => part.Kind == SegmentKind.Ellipse));
        Assert.Empty(drawing.Balance.RefusedInBlocks);
        Assert.Equal(1, drawing.Balance.Cut);
    }

    [Fact]
    public void Curves_keep_their_place_between_the_inserts_of_a_block()
    {
        (int, object)[] mark = [(0, "CIRCLE"), (10, 0), (20, 0), (40, 1)];
        var drawing = Drawing(
            [.. Block("A", 0, 0, mark), .. Block("B", 0, 0, [.. LineAndArc[..6], .. Insert("A"), .. LineAndArc[6..]])],
            Insert("B"));

        Assert.Equal("Line Circle Arc", string.Join(' ', DxfReading.Curves(drawing).Select(entity => entity.Type)));
    }

    [Fact]
    public void Content_on_layer_0_takes_the_layer_of_the_insert_through_every_level()
    {
        var drawing = Drawing(
            [.. Block("A", 0, 0, LineAndArc), .. Block("B", 0, 0, [(0, "INSERT"), (8, "0"), (2, "A"), (10, 0), (20, 0)])],
            [(0, "INSERT"), (8, "Outer"), (2, "B"), (10, 0), (20, 0)]);

        Assert.Equal("Outer CUT", string.Join(' ', DxfReading.Curves(drawing).Select(entity => drawing.Layers[entity.Layer].Name)));
    }

    [Theory]
    [InlineData(1, 0, true)]
    [InlineData(0, 1, true)]
    [InlineData(0, 0, false)]
    public void A_frozen_or_invisible_insert_hides_all_its_content(int frozen, int invisible, bool hidden)
    {
        var drawing = DxfReading.Of(new DxfText()
            .Section("TABLES", (0, "LAYER"), (2, "F"), (70, frozen), (62, 7))
            .Section("BLOCKS", Block("A", 0, 0, LineAndArc))
            .Section("ENTITIES", (0, "INSERT"), (8, "f"), (2, "a"), (60, invisible), (10, 0), (20, 0))
            .End());

        Assert.Equal(2, drawing.Entities.Count);
        Assert.All(DxfReading.Curves(drawing), entity => Assert.Equal(hidden, entity.Hidden));
    }

    [Fact]
    public void Blocks_and_layers_behind_the_entities_are_found()
    {
        var drawing = DxfReading.Of(new DxfText()
            .Section("ENTITIES", [(0, "INSERT"), (8, "F"), (2, "A"), (10, 0), (20, 0), .. LineAndArc])
            .Section("TABLES", (0, "LAYER"), (2, "F"), (70, 1))
            .Section("BLOCKS", Block("A", 0, 0, LineAndArc))
            .End());

        Assert.Equal("True True False False", string.Join(' ', DxfReading.Curves(drawing).Select(entity => entity.Hidden)));
    }

    [Fact]
    public void An_insert_is_cut_or_construction_by_what_comes_out_of_it()
    {
        var drawing = Drawing(
            [.. Block("A", 0, 0, LineAndArc), .. Block("T", 0, 0, [(0, "TEXT"), (1, "x"), (0, "POINT"), (10, 0), (20, 0)])],
            [.. Insert("A"), .. Insert("T"), (0, "INSERT"), (66, 1), (2, "T"), (10, 0), (20, 0), (0, "ATTRIB"), (1, "a"), (0, "SEQEND")]);

        Assert.Equal((3, 1, 2), (drawing.Balance.Read, drawing.Balance.Cut, drawing.Balance.Construction));
        Assert.Equal((2, 1, 2), (drawing.Balance.TextCounts["TEXT"], drawing.Balance.TextCounts["ATTRIB"], drawing.Balance.Points));
    }

    [Fact]
    public void Trouble_in_a_block_is_told_once_and_only_when_the_block_is_used()
    {
        (int, object)[] spline = [(0, "SPLINE"), (5, "99"), (71, 3)];
        var blocks = (ReadOnlySpan<(int, object)>)[.. Block("A", 0, 0, [.. LineAndArc, .. spline]), .. Block("Unused", 0, 0, spline)];

        var drawing = Drawing(blocks, [.. Insert("A"), .. Insert("A")]);

        Assert.Equal(("SPLINE", "99"), Assert.Single(drawing.Balance.RefusedInBlocks) is var refused ? (refused.Type, refused.Handle) : default);
        Assert.Equal(2, drawing.Balance.Cut);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(0)]
    public void A_bomb_of_nested_blocks_is_refused_by_name_before_it_goes_off(int curves)
    {
        var blocks = new List<(int, object)>(Block("L0", 0, 0, curves == 1 ? LineAndArc : [(0, "TEXT"), (1, "x")]));
        for (var level = 1; level <= 60; level++) blocks.AddRange(Block($"L{level}", 0, 0, [.. Insert($"L{level - 1}"), .. Insert($"L{level - 1}")]));

        var drawing = Drawing([.. blocks], [.. Insert("L60"), .. LineAndArc]);

        Assert.Equal(2, drawing.Entities.Count);
        Assert.Equal(curves, drawing.Diagnostics.Count(diagnostic => diagnostic.Id == "DXF0019" && diagnostic.Message.Contains("'L60'", StringComparison.Ordinal)));
    }

    [Fact]
    public void Nested_blocks_without_curves_cost_nothing()
    {
        var blocks = new List<(int, object)>(Block("L0", 0, 0, [(0, "TEXT"), (1, "x")]));
        for (var level = 1; level <= 60; level++) blocks.AddRange(Block($"L{level}", 0, 0, [.. Insert($"L{level - 1}"), .. Insert($"L{level - 1}")]));

        var drawing = Drawing([.. blocks, .. Block("A", 0, 0, [.. LineAndArc, .. Insert("L60")])], Insert("A"));

        Assert.Equal((2, 0), (drawing.Entities.Count, drawing.Balance.Refused.Count));
    }

    [Fact]
    public void A_hundred_thousand_levels_of_nesting_are_expanded()
    {
        var drawing = Drawing(Chain(100_000, (0, "TEXT"), (1, "deep"), (10, 1), (20, 2), (40, 1)), [(0, "INSERT"), (2, "L100000"), (10, 5), (20, 0)]);

        Assert.Empty(drawing.Diagnostics);
        Assert.Equal((2, 100_006.0, 1.0), (drawing.Entities.Count, drawing.Parts[0].A, drawing.Parts[0].B));
        Assert.Equal(("deep", 100_006.0), (Assert.Single(drawing.Texts).Content, drawing.Texts[0].Position.X));
    }

    [Fact]
    public void A_circle_of_blocks_a_hundred_thousand_levels_down_is_refused_by_name()
    {
        var drawing = Drawing(Chain(100_000, Insert("L100000")), Insert("L100000"));

        Assert.Equal(2, drawing.Entities.Count);
        Assert.Equal(("DXF0018", "INSERT"), Assert.Single(drawing.Balance.RefusedInBlocks) is var refused ? (refused.DiagnosticId, refused.Type) : default);
        Assert.Contains(drawing.Diagnostics, finding => finding.Message.Contains("'L100000'", StringComparison.Ordinal));
    }

    [Fact]
    public void An_array_inside_an_array_is_drawn_row_by_row_and_copy_by_copy()
    {
        var drawing = Drawing(
            [.. Block("A", 0, 0, [(0, "CIRCLE"), (10, 0), (20, 0), (40, 1)]), .. Block("B", 0, 0, [(0, "CIRCLE"), (10, 0), (20, 0), (40, 2), .. Insert("A"), (70, 2), (44, 1), (0, "CIRCLE"), (10, 0), (20, 0), (40, 3)])],
            [.. Insert("B"), (71, 2), (45, 100)]);

        Assert.Equal("0,0,2 0,0,1 1,0,1 0,0,3 0,100,2 0,100,1 1,100,1 0,100,3", string.Join(' ', DxfReading.Parts(drawing).Select(part => $"{part.A:0},{part.B:0},{part.D:0}")));
    }

    [Fact]
    public void Inserts_that_bring_nothing_count_towards_the_limit_too()
    {
        (int, object)[] idle = [.. Enumerable.Repeat(Insert("Nothing"), 10).SelectMany(pairs => pairs)];
        var text = new DxfText().Section("BLOCKS", [.. Block("Nothing", 0, 0, []), .. Block("A", 0, 0, [.. LineAndArc, .. idle])]).Section("ENTITIES", Insert("A")).End();

        Assert.Equal(2, DxfReading.Of(text.ToAscii(), new DxfReadOptions(MaxExpandedCurves: 12)).Entities.Count);
        Assert.Equal(0, DxfReading.Of(text.ToAscii(), new DxfReadOptions(MaxExpandedCurves: 11)).Entities.Count);
    }

    [Fact]
    public void The_limit_of_curves_is_one_for_the_whole_drawing()
    {
        var text = new DxfText().Section("BLOCKS", Block("A", 0, 0, LineAndArc)).Section("ENTITIES", [.. Insert("A"), .. Insert("A"), .. Insert("A")]).End();

        var drawing = DxfReading.Of(text.ToAscii(), new DxfReadOptions(MaxExpandedCurves: 5));

        Assert.Equal((4, 1), (drawing.Entities.Count, drawing.Balance.Refused.Count));
    }

    [Fact]
    public void Blocks_that_contain_themselves_give_what_they_have_besides()
    {
        var drawing = Drawing([.. Block("A", 0, 0, [.. LineAndArc, .. Insert("b")]), .. Block("B", 0, 0, [.. LineAndArc, .. Insert("a")])], Insert("A"));

        Assert.Equal(4, drawing.Entities.Count);
        Assert.Equal("DXF0018", Assert.Single(drawing.Balance.RefusedInBlocks).DiagnosticId);
    }

    private static Drawing Drawing(ReadOnlySpan<(int, object)> blocks, ReadOnlySpan<(int, object)> entities) =>
        DxfReading.Of(new DxfText().Header("AC1015", 4).Section("BLOCKS", blocks).Section("ENTITIES", entities).End());

    /// <summary>L0 contains a line, an arc and the given content; each further block contains only the previous one, moved by 1 along x.</summary>
    private static (int, object)[] Chain(int levels, params ReadOnlySpan<(int, object)> innermost)
    {
        var blocks = new List<(int, object)>(Block("L0", 0, 0, [.. LineAndArc, .. innermost]));
        for (var level = 1; level <= levels; level++) blocks.AddRange(Block($"L{level}", 0, 0, [(0, "INSERT"), (2, $"L{level - 1}"), (10, 1), (20, 0)]));
        return [.. blocks];
    }

    private static (int, object)[] Block(string name, double baseX, double baseY, ReadOnlySpan<(int, object)> content) =>
        [(0, "BLOCK"), (2, name), (10, baseX), (20, baseY), .. content, (0, "ENDBLK")];

    private static (int, object)[] Insert(string block) => [(0, "INSERT"), (2, block), (10, 0), (20, 0)];

    private static Arbitrary<Placing> Inserts() =>
        (from x in Gen.Choose(-100, 100)
         from y in Gen.Choose(-100, 100)
         from scale in Gen.Elements(0.5, 1.0, 3.0)
         from mirrorX in Gen.Elements(1.0, -1.0)
         from mirrorY in Gen.Elements(1.0, -1.0)
         from turn in Gen.Choose(-720, 720)
         from up in Gen.Elements(1.0, -1.0)
         select new Placing(x, y, scale * mirrorX, scale * mirrorY, turn / 2.0, up)).ToArbitrary();

    /// <summary>An INSERT and, written independently of the product, its effect on a point.</summary>
    private sealed record Placing(double X, double Y, double ScaleX, double ScaleY, double Turn, double Up)
    {
        public (int, object)[] Pairs(string block) =>
            [(0, "INSERT"), (2, block), (10, X), (20, Y), (41, ScaleX), (42, ScaleY), (50, Turn), (210, 0.0), (220, 0.0), (230, Up)];

        public Point2D Map(Point2D point, double baseX, double baseY)
        {
            var (sin, cos) = Math.SinCos(Turn * Math.PI / 180.0);
            var (x, y) = ((point.X - baseX) * ScaleX, (point.Y - baseY) * ScaleY);
            return new Point2D(Up * (X + (x * cos) - (y * sin)), Y + (x * sin) + (y * cos));
        }
    }
}
