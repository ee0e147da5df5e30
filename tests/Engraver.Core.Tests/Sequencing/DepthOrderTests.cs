using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing;

/// <summary>If heights are cut, the nearest start is not chosen when it would plunge into uncleared material.</summary>
public class DepthOrderTests
{
    private static readonly SequencingOptions Cutting = UsualOptions.Sequencing with { CutsHeights = true };

    [Theory]
    [InlineData(StrokeOrder.Nearest)]
    [InlineData(StrokeOrder.Drawn)]
    public void The_same_path_at_several_depths_is_cut_from_above(StrokeOrder order)
    {
        double[] drawn = order == StrokeOrder.Nearest ? [-3, -1, -2] : [-1, -2, -3];
        (int, object)[] squares = [.. drawn.SelectMany(z => Square(0, 10, z))];

        Assert.Equal([-1, -2, -3], Heights(squares, Cutting with { Order = order }));
    }

    [Fact]
    public void A_machine_without_heights_takes_the_nearest() =>
        Assert.Equal([-2, -1], Heights([.. Line(0, 0, -2, 20, 0, -2), .. Line(20, 0.5, -1, 0, 0.5, -1)], UsualOptions.Sequencing));

    [Fact]
    public void Lines_are_cut_from_above_from_whichever_end_is_nearer()
    {
        (int, object)[] lines = [.. Line(0, 0, -2, 20, 0, -2), .. Line(20, 0, -1, 0, 0, -1), .. Line(0, 5, -2, 20, 5, -2)];

        var strokes = Sequence(lines, Cutting).Strokes;

        Assert.Equal([(0.0, 0.0, -1.0), (20.0, 0.0, -2.0), (0.0, 5.0, -2.0)], strokes.Select(stroke => (stroke.Start.X, stroke.Start.Y, stroke.Moves[0].StartZ)));
    }

    [Fact]
    public void What_goes_down_is_entered_at_its_upper_end()
    {
        var strokes = Sequence([.. Line(0, 0, -1, 30, 0, 0), .. Line(0, 8, 0, 30, 8, -1)], Cutting).Strokes;

        Assert.Equal([(0.0, 8.0, 0.0), (30.0, 0.0, 0.0)], strokes.Select(stroke => (stroke.Start.X, stroke.Start.Y, stroke.Moves[0].StartZ)));
        Assert.Equal(new Point2D(0, 0), Sequence([.. Line(0, 0, -1, 30, 0, 0), .. Line(0, 8, 0, 30, 8, -1)], UsualOptions.Sequencing).Strokes[0].Start);
    }

    [Fact]
    public void A_hole_is_cut_before_the_last_depth_of_its_outline_and_both_from_above()
    {
        (int, object)[] plate = [.. Square(0, 30, -2), .. Square(10, 10, -2), .. Square(0, 30, -1), .. Square(10, 10, -1)];

        var cut = Sequence(plate, Cutting).Strokes.Select(stroke => (stroke.Moves[0].Segment.Length, stroke.Moves[0].StartZ)).ToList();

        Assert.Equal((30.0, -2.0), cut[^1]);
        Assert.Equal([-1.0, -2.0], cut.Where(one => one.Length == 10.0).Select(one => one.StartZ));
        Assert.Equal([-1.0, -2.0], cut.Where(one => one.Length == 30.0).Select(one => one.StartZ));
    }

    /// <summary>The entry entity is the operator's choice; strokes that wait for others still follow, each once.</summary>
    [Fact]
    public void Entering_at_a_deep_one_leaves_nothing_out()
    {
        (int, object)[] rings = [.. Square(0, 10, -1), .. Square(0, 10, -2), .. Ring(-1, (20, 0), (60, 0), (60, 40), (20, 40)), .. Ring(-1, (30, 10), (40, 10), (40, 20)), .. Ring(-2, (30, 10), (40, 10), (40, 20)), .. Line(30, 10, -3, 40, 10, -3)];
        var strokes = Sequence(rings, Cutting with { Entry = new EntryRequest.AtPlace(new Point2D(60, 0)) }).Strokes;

        Assert.Equal(6, strokes.Count);
        Assert.Equal([-1, -2], strokes.Where(stroke => stroke.Start.X < 15).Select(stroke => stroke.Moves[0].StartZ));
        Assert.Equal([-1, -2, -3], strokes.Where(stroke => stroke.Start.X is > 25 and < 45).Select(stroke => stroke.Moves[0].StartZ));
    }

    [Fact]
    public void The_entered_outline_comes_before_what_lies_outside_of_it_and_waited_for_its_hole()
    {
        (int, object)[] path = [.. Path(-2, (30, 10), (40, 10), (80, 10), (90, 10), (100, 10), (110, 10))];
        (int, object)[] all = [.. Ring(-1, (20, 0), (60, 0), (60, 40), (20, 40)), .. Ring(-1, (30, 10), (40, 10), (40, 20)), .. path];

        var strokes = Sequence(all, Cutting with { Entry = new EntryRequest.AtPlace(new Point2D(60, 0)) }).Strokes;

        Assert.Equal([3, 4, 5], strokes.Select(stroke => stroke.Segments));
    }

    /// <summary>The outline crosses an edge of the innermost square, which is in the middle one, which is in the outline.</summary>
    [Fact]
    public void What_waits_for_each_other_is_cut_all_the_same()
    {
        (int, object)[] all =
        [
            .. Ring(-1, (0, 0), (10, 0), (20, 0), (30, 0), (30, 30), (0, 30)),
            .. Ring(-1, (5, 0), (25, 0), (25, 20), (5, 20)),
            .. Ring(-2, (10, 0), (20, 0), (20, 10), (10, 10)),
        ];

        Assert.Equal(3, Sequence(all, Cutting).Strokes.Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Random_stacks_are_cut_whole_and_from_above(int seed)
    {
        var random = new Random(seed);
        (double X, double Z)[] stacks = [.. Enumerable.Range(0, 12).SelectMany(i => Enumerable.Range(1, random.Next(1, 6)).Select(level => (20.0 * i, -0.5 * level)))];
        random.Shuffle(stacks);

        var strokes = Sequence([.. stacks.SelectMany(one => Square(one.X, 10, one.Z))], Cutting with { ToolStart = new Point2D(random.Next(300), 5) }).Strokes;

        Assert.Equal(stacks.Length, strokes.Count);
        Assert.All(strokes.GroupBy(stroke => Math.Floor(stroke.Start.X / 20.0)), stack => Assert.Equal(stack.Select(one => one.Moves[0].StartZ).OrderDescending(), stack.Select(one => one.Moves[0].StartZ)));
    }

    private static IEnumerable<double> Heights((int, object)[] entities, SequencingOptions options) => Sequence(entities, options).Strokes.Select(stroke => stroke.Moves[0].StartZ);

    private static SequencingResult Sequence((int, object)[] entities, SequencingOptions options)
    {
        var drawing = DxfReading.Entities(entities);
        return Sequencer.Sequence(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), drawing, options);
    }

    private static (int, object)[] Line(double x1, double y1, double z1, double x2, double y2, double z2) => [(0, "LINE"), (10, x1), (20, y1), (30, z1), (11, x2), (21, y2), (31, z2)];

    private static (int, object)[] Ring(double z, params (double X, double Y)[] corners) => Polyline(1, z, corners);

    private static (int, object)[] Path(double z, params (double X, double Y)[] corners) => Polyline(0, z, corners);

    private static (int, object)[] Polyline(int flags, double z, (double X, double Y)[] corners) =>
        [(0, "LWPOLYLINE"), (38, z), (90, corners.Length), (70, flags), .. corners.SelectMany(corner => new (int, object)[] { (10, corner.X), (20, corner.Y) })];

    private static (int, object)[] Square(double at, double side, double z) => Ring(z, (at, at % 20), (at + side, at % 20), (at + side, side + (at % 20)), (at, side + (at % 20)));
}
