using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Sequencing;

public class SequencerTests
{
    private static readonly SequencingOptions Nearest = UsualOptions.Sequencing;
    private static readonly SequencingOptions Drawn = UsualOptions.Sequencing with { Order = StrokeOrder.Drawn };
    private static readonly Arbitrary<int> s_seeds = Gen.Choose(0, int.MaxValue).ToArbitrary();

    [Theory]
    [InlineData(-1, 98)]
    [InlineData(201, 102)]
    [InlineData(100, 102)]
    public void A_circle_starts_at_the_quadrant_point_nearer_to_the_tool_and_at_the_right_one_in_a_tie(double toolX, double startX)
    {
        var drawing = new DrawingBuilder().Circle(100, 0, 2);

        foreach (var order in new[] { Nearest, Drawn })
        {
            var result = Sequence(drawing, order with { ToolStart = new Point2D(toolX, 0) });
            Assert.Equal(new Point2D(startX, 0), result.Strokes[0].Start);
        }
    }

    /// <summary>The distance between the ends of one line is the line, and not a gap.</summary>
    [Fact]
    public void The_own_other_end_of_a_short_line_is_no_gap_and_that_of_a_nearly_closed_arc_is()
    {
        var short1 = Sequence(new DrawingBuilder().Line(10, 10, 10.5, 10), Nearest);
        var dots = Sequence(Enumerable.Range(0, 40).Aggregate(new DrawingBuilder(), (drawing, i) => drawing.Line(2 * i, i, (2 * i) + 0.3, i)), Nearest);
        var near = Sequence(new DrawingBuilder().Line(0, 0, 0.4, 0).Line(0.7, 0, 20, 0), Nearest);
        var arc = Sequence(new DrawingBuilder().Arc(0, 0, 5, 2, 360), Nearest);

        Assert.DoesNotContain(short1.Diagnostics.Concat(dots.Diagnostics), finding => finding.Id == "SEQ0003");
        Assert.All(short1.Discontinuities.Concat(dots.Discontinuities), end => Assert.Equal("SEQ0002", end.DiagnosticId));
        Assert.Equal([0.7, 0.3, 0.3], near.Discontinuities.Where(end => end.DiagnosticId == "SEQ0003").Select(end => Math.Round(end.Gap!.Value, 9)));
        Assert.Equal(2, arc.Diagnostics.Count(finding => finding.Id == "SEQ0003"));
    }

    [Fact]
    public void A_gap_that_the_tolerance_already_joins_is_no_reason_to_raise_it()
    {
        var result = Sequence(new DrawingBuilder().Line(0, 0, 10, 0).Line(0, 0.5, 10, 0.5).Line(0, 1, 10, 1).Line(0, 1.5, 10, 1.5).Line(0, 2, 10, 2), Nearest with { JoinTolerance = 0.6 });

        Assert.All(result.Diagnostics.Where(finding => finding.Id == "SEQ0003"), finding => Assert.True(double.Parse(finding.Facts[2], System.Globalization.CultureInfo.InvariantCulture) > 0.6));
        Assert.All(result.Discontinuities.Where(end => end.DiagnosticId == "SEQ0003"), end => Assert.True(end.Gap > 0.6));
    }

    [Theory]
    [InlineData(10, 20, 10, 15)]
    [InlineData(10, 10.2, 10, 15)] // inside
    [InlineData(14, 13, 14, 13)]
    [InlineData(10, 10, 15, 10)] // the middle, from which every point is as far
    public void A_circle_is_entered_at_its_point_nearest_to_the_place(double x, double y, double startX, double startY)
    {
        var stroke = Sequence(new DrawingBuilder().Line(100, 0, 120, 0).Circle(10, 10, 5), Nearest with { Entry = new EntryRequest.AtPlace(new Point2D(x, y)) }).Strokes[0];

        Assert.Equal((startX, startY), (Math.Round(stroke.Start.X, 9), Math.Round(stroke.Start.Y, 9)));
        Assert.Equal(stroke.Start, stroke.End);
        Assert.Equal(10.0 * Math.PI, stroke.Length, 1e-9);
    }

    [Fact]
    public void A_circle_begun_on_the_left_has_its_row_rewritten()
    {
        var row = Sequence(new DrawingBuilder().Circle(100, 0, 2), Nearest).Table[0];

        Assert.Equal(new double[] { 2, 98, 0, 0, 98, 0, 0, 100, 0, 0, 2, 180, 540, 1, 0, 360 }, row.Slots.ToArray());
    }

    [Fact]
    public void An_arc_run_backwards_has_ends_and_angles_swapped_and_a_negative_rotation()
    {
        var result = Sequence(new DrawingBuilder().Arc(0, 0, 10, 0, 90), Nearest with { ToolStart = new Point2D(0, 11) });

        Assert.Equal(new double[] { 3, 0, 10, 0, 10, 0, 0, 0, 0, 0, 10, 90, 0, 1, 0, -90 }, result.Table[0].Slots.ToArray());
        Assert.Equal(1, result.Reversed);
    }

    [Fact]
    public void A_closed_contour_starts_at_the_joint_nearest_to_the_tool()
    {
        var result = Sequence(new DrawingBuilder().Square(0, 0, 10), Nearest with { ToolStart = new Point2D(12, 12) });

        Assert.Equal((new Point2D(10, 10), new Point2D(10, 10)), (result.Strokes[0].Start, result.Strokes[0].End));
        Assert.Equal(0, result.Reversed);
    }

    [Fact]
    public void Travel_is_the_way_to_each_start_and_back_home_at_the_end()
    {
        var result = Sequence(new DrawingBuilder().Line(3, 4, 3, 10).Line(20, 10, 11, 10), Nearest);

        Assert.Equal(5.0 + 8.0, result.Travel, 12);
        Assert.Equal(13.0 + Math.Sqrt(500.0), result.TravelAndBack, 12);
        Assert.Equal(5.0 + 17.0, result.TravelAsDrawn, 12);
        Assert.Equal(6.0 + 9.0, result.PathLength, 12);
    }

    [Fact]
    public void Travel_as_drawn_takes_a_polyline_as_one_curve_and_counts_duplicates()
    {
        var result = Sequence(new DrawingBuilder().Square(10, 0, 5).Line(10, 0, 0, 0).Line(10, 0, 0, 0), Nearest);

        Assert.Equal(10.0 + 0.0 + 10.0, result.TravelAsDrawn, 12);
        Assert.Equal(1, result.DuplicatesRemoved);
    }

    [Fact]
    public void Duplicates_stay_when_asked_for() =>
        Assert.Equal((2, 0), Sequence(new DrawingBuilder().Circle(0, 0, 1).Circle(0, 0, 1), Nearest with { KeepDuplicates = true }) is var kept
            ? (kept.Contours, kept.DuplicatesRemoved)
            : default);

    [Fact]
    public void An_ellipse_counts_as_one_segment_and_polyline_parts_count_each()
    {
        var halves = new[] { Half(0), Half(180) };

        Assert.Equal(1, Sequence(new DrawingBuilder().Curve(CurveType.Ellipse, halves), Nearest).Segments);
        Assert.Equal(2, Sequence(new DrawingBuilder().Curve(CurveType.LwPolyline, halves), Nearest).Segments);
    }

    [Property]
    public Property What_is_inside_is_cut_before_what_is_around_it_in_the_nearest_order() => Prop.ForAll(s_seeds, seed => IsInsideFirst(seed, Nearest));

    [Property]
    public Property What_is_inside_is_cut_before_what_is_around_it_in_the_drawn_order() => Prop.ForAll(s_seeds, seed => IsInsideFirst(seed, Drawn));

    [Property]
    public Property The_table_is_numbered_from_one_and_every_row_of_the_drawing_is_in_it_once() =>
        Prop.ForAll(LoosePolylines.Any, loose =>
        {
            var builder = new DrawingBuilder();
            foreach (var segment in loose.Shuffled) builder.Curve(segment.Kind == SegmentKind.Line ? CurveType.Line : CurveType.LwPolyline, segment);
            var table = Sequence(builder, Nearest).Table;
            var rows = Enumerable.Range(0, table.Count).ToList();
            return rows.TrueForAll(row => table[row].SequenceNumber == row + 1)
                && rows.Select(table.EntityIndexOf).Order().SequenceEqual(Enumerable.Range(0, loose.Shuffled.Length));
        });

    [Property]
    public Property Every_contour_is_cut_whole_wherever_the_tool_starts() =>
        Prop.ForAll(LoosePolylines.Any, Gen.Choose(-100, 500).Two().ToArbitrary(), (loose, tool) =>
        {
            var builder = new DrawingBuilder();
            foreach (var segment in loose.Shuffled) builder.Curve(CurveType.LwPolyline, segment);
            var result = Sequence(builder, Nearest with { ToolStart = new Point2D(tool.Item1, tool.Item2) });
            return result.Contours == loose.Polylines.Count
                && Math.Abs(result.PathLength - loose.Shuffled.Sum(segment => segment.Length)) < 1e-6
                && result.Strokes.All(IsJoined);
        });

    /// <summary>Many contours in a grid of cells, few in a tree of boxes, and inner contours first: compared one by one, no available start is nearer than the
    /// chosen one.</summary>
    [Theory]
    [InlineData(1, 300, 40)]
    [InlineData(2, 900, 40)]
    [InlineData(3, 60, 40)]
    [InlineData(4, 30, 8)] // in a tree of boxes
    public void The_next_stroke_is_always_the_nearest_that_may_be_cut(int seed, int lines, int closed)
    {
        var random = new Random(seed);
        var drawing = new DrawingBuilder();
        for (var i = 0; i < lines; i++) drawing.Line(random.Next(400), random.Next(400), random.Next(400) + 0.5, random.Next(400) + 0.5);
        for (var i = 0; i < closed; i++) drawing.Square(random.Next(400) + 0.25, random.Next(400) + 0.25, 3 + random.Next(30)).Circle(random.Next(400) + 0.7, random.Next(400) + 0.7, 1 + random.Next(9));
        var strokes = Sequence(drawing, Nearest).Strokes;
        var (left, tool) = (strokes.ToList(), Nearest.ToolStart);
        while (left.Count > 0)
        {
            var waiting = left.Select(stroke => stroke.Inside).ToHashSet();
            var nearest = left.Where(stroke => !waiting.Contains(stroke.Index)).Min(stroke => Starts(stroke).Min(tool.DistanceTo));
            Assert.Equal(nearest, tool.DistanceTo(left[0].Start));
            tool = left[0].End;
            left.RemoveAt(0);
        }

        static IEnumerable<Point2D> Starts(SequencedStroke stroke)
        {
            if (!stroke.Closed) return [stroke.Start, stroke.End];
            if (stroke.Moves[0].Segment is not { Kind: SegmentKind.Circle, Arc: var circle }) return stroke.Moves.Select(move => move.Segment.Start);
            return [circle.Centre + new Vector2D(circle.Radius, 0.0), circle.Centre - new Vector2D(circle.Radius, 0.0)];
        }
    }

    /// <summary>Warnings stop at a hundred and are counted; the list of open ends is complete.</summary>
    [Fact]
    public void A_thousand_small_gaps_are_a_hundred_warnings_and_a_count()
    {
        var drawing = new DrawingBuilder();
        for (var i = 0; i < 501; i++) drawing.Line(i * 10, 0, (i * 10) + 9.5, 0);
        var result = Sequence(drawing, Nearest);

        Assert.Equal(100, result.Diagnostics.Count(finding => finding.Id == "SEQ0003"));
        var rest = Assert.Single(result.Diagnostics, finding => finding.Id == "SEQ0014");
        Assert.Contains("SEQ0003 occurred 1000 times", rest.Message, StringComparison.Ordinal);
        Assert.Equal((1002, 1000), (result.Discontinuities.Count, result.Discontinuities.Count(end => end.DiagnosticId == "SEQ0003")));
    }

    /// <summary>They are counted without being measured; the list measures them.</summary>
    [Theory]
    [InlineData(1, 400)]
    [InlineData(2, 40)]
    [InlineData(3, 3)]
    public void Small_gaps_and_other_open_ends_are_counted_as_the_list_has_them(int seed, int lines)
    {
        var random = new Random(seed);
        var drawing = new DrawingBuilder();
        for (var i = 0; i < lines; i++) drawing.Line(random.Next(200) / 4.0, random.Next(200) / 4.0, random.Next(200) / 4.0, random.Next(200) / 4.0);
        var result = Sequence(drawing, Nearest);

        var small = result.Discontinuities.Count(end => end.Gap < ContourEnds.WidestGap);
        var counted = result.Diagnostics.SingleOrDefault(finding => finding.Id == "SEQ0014" && finding.Facts[0] == "SEQ0003")?.Facts[1] ?? $"{result.Diagnostics.Count(finding => finding.Id == "SEQ0003")}";
        var wide = result.Diagnostics.SingleOrDefault(finding => finding.Id == "SEQ0002")?.Facts[1] ?? "0";
        Assert.Equal(($"{small}", $"{result.Discontinuities.Count - small}"), (counted, wide));
        Assert.Equal(result.Discontinuities.Where(end => end.DiagnosticId == "SEQ0003").Select(end => end.Place).Take(100), result.Diagnostics.Where(finding => finding.Id == "SEQ0003").Select(finding => finding.Place!.Value));
    }

    [Fact]
    public void A_hundred_small_gaps_are_a_hundred_warnings()
    {
        var drawing = new DrawingBuilder();
        for (var i = 0; i < 51; i++) drawing.Line(i * 10, 0, (i * 10) + 9.5, 0);

        Assert.Equal(["SEQ0002", "SEQ0003"], Sequence(drawing, Nearest).Diagnostics.Select(finding => finding.Id).Distinct().Order());
    }

    [Fact]
    public void The_entering_entity_is_cut_first_and_begun_at_itself()
    {
        var drawing = new DrawingBuilder().Line(1, 0, 2, 0).Line(50, 0, 60, 0).Line(60, 0, 60, 10).Line(60, 10, 50, 0);

        foreach (var order in new[] { Nearest, Drawn })
        {
            var result = Sequence(drawing, order with { Entry = new EntryRequest.AtEntity(2) });
            Assert.Equal(2, result.Table.EntityIndexOf(0));
            Assert.Equal(new Point2D(60, 0), result.Strokes[0].Start);
        }
    }

    [Fact]
    public void The_entering_place_chooses_the_end_of_an_open_stroke()
    {
        var result = Sequence(new DrawingBuilder().Line(1, 0, 2, 0).Line(50, 0, 60, 0), Nearest with { Entry = new EntryRequest.AtPlace(new Point2D(61, 0)) });

        Assert.Equal(new Point2D(60, 0), result.Strokes[0].Start);
    }

    [Fact]
    public void Entering_at_an_outer_contour_still_cuts_what_is_inside_it_first()
    {
        var drawing = new DrawingBuilder().Circle(1, 1, 0.5).Square(50, 50, 20).Circle(60, 60, 2);

        foreach (var order in new[] { Nearest, Drawn })
        {
            var result = Sequence(drawing, order with { Entry = new EntryRequest.AtEntity(1) });
            Assert.Equal([2, 1, 1, 1, 1, 0], Enumerable.Range(0, result.Table.Count).Select(result.Table.EntityIndexOf));
            Assert.Contains(result.Diagnostics, d => d.Rule == SequencingRules.EntryWaits);
        }
    }

    [Fact]
    public void An_entering_entity_that_is_not_cut_is_said_so()
    {
        var result = Sequence(new DrawingBuilder().Circle(0, 0, 1), Nearest with { Entry = new EntryRequest.AtEntity(7) });

        Assert.Equal([SequencingRules.EntryNotFound], result.Diagnostics.Select(d => d.Rule));
        Assert.Equal(1, result.Contours);
    }

    [Fact]
    public void An_entering_entity_that_was_drawn_twice_is_entered_at_its_double()
    {
        var drawing = new DrawingBuilder().Line(1, 0, 2, 0).Line(50, 0, 60, 0).Line(55, -5, 55, 5).Line(60, 0, 50, 0);
        var result = Sequence(drawing, Nearest with { Entry = new EntryRequest.AtEntity(3) });

        Assert.Equal(1, result.Table.EntityIndexOf(0));
        var said = Assert.Single(result.Diagnostics, d => d.Rule == SequencingRules.EntryStandsIn);
        Assert.StartsWith("The entering entity A4 is a duplicate or part of a recovered arc. Entity A2 is cut instead", said.Message, StringComparison.Ordinal);
        Assert.DoesNotContain(result.Diagnostics, d => d.Rule == SequencingRules.EntryNotFound);
    }

    [Fact]
    public void An_entering_line_that_was_recovered_as_an_arc_is_entered_at_that_arc()
    {
        var drawing = new DrawingBuilder().Line(1, 0, 2, 0);
        for (var i = 0; i < 24; i++) drawing = drawing.Line(OnCircle(i).X, OnCircle(i).Y, OnCircle(i + 1).X, OnCircle(i + 1).Y);
        var result = Sequence(drawing, Nearest with { ArcTolerance = 0.01, Entry = new EntryRequest.AtEntity(14) });

        Assert.Equal(2, result.Table.Count);
        Assert.Equal(1, result.Table.EntityIndexOf(0));
        Assert.Contains(result.Diagnostics, d => d.Rule == SequencingRules.EntryStandsIn && d.Message.Contains("entity AF is a duplicate or part", StringComparison.Ordinal));

        static Point2D OnCircle(int step) => new(80 + (5 * Math.Cos(step * Math.PI / 36)), 5 * Math.Sin(step * Math.PI / 36));
    }

    [Theory]
    [InlineData(0.002)]
    [InlineData(0.004)]
    [InlineData(0.00001)]
    public void A_contour_smaller_than_the_join_tolerance_closes_where_its_ends_meet_and_has_no_open_end(double side)
    {
        var drawing = new DrawingBuilder().Line(5, 5, 5 + side, 5).Line(5 + side, 5, 5 + side, 5 + side).Line(5, 5 + side, 5 + side, 5 + side).Line(5, 5 + side, 5, 5).Line(0, 0, 5, 0);
        var result = Sequence(drawing, Nearest);

        Assert.Equal((1, 1, 2), (result.Closed, result.Open, result.Discontinuities.Count));
        Assert.DoesNotContain(result.Diagnostics, d => d.Severity == Severity.Warning);
    }

    [Fact]
    public void A_line_shorter_than_the_join_tolerance_stays_open_for_its_ends_do_not_meet()
    {
        var result = Sequence(new DrawingBuilder().Line(5, 5, 5.004, 5).Line(5.004, 5, 5.004, 5.003), Nearest);

        Assert.Equal((0, 1), (result.Closed, result.Open));
    }

    [Fact]
    public void Drawn_order_keeps_file_order_and_drawn_directions()
    {
        var result = Sequence(new DrawingBuilder().Line(60, 0, 50, 0).Line(1, 0, 2, 0), Drawn);

        Assert.Equal([0, 1], Enumerable.Range(0, 2).Select(result.Table.EntityIndexOf));
        Assert.Equal(new Point2D(60, 0), result.Strokes[0].Start);
    }

    [Theory]
    [InlineData(CurveType.Text)]
    [InlineData(CurveType.MText)]
    [InlineData(CurveType.Attribute)]
    public void The_ends_of_letters_are_no_gaps_and_the_ends_of_lines_beside_them_are(CurveType letters)
    {
        Segment Of(double x) => Segment.FromLine(new Point2D(x, 0), new Point2D(x, 5));
        var result = Sequence(new DrawingBuilder().Curve(letters, Of(0.25), Of(0.5), Of(1.0)).Line(0, 0, 0, 5).Line(-0.5, 0, -0.5, 5), Nearest);
        var alone = Sequence(new DrawingBuilder().Curve(letters, Of(0.25), Of(0.5), Of(1.0)), Nearest);

        Assert.Equal((5, 4), (result.Open, result.Discontinuities.Count));
        Assert.Equal([0.5, 0.5, 0.5, 0.5], result.Discontinuities.Select(end => end.Gap!.Value));
        Assert.Equal(4, result.Diagnostics.Count(finding => finding.Id == "SEQ0003"));
        Assert.Equal((3, 0, 0), (alone.Open, alone.Discontinuities.Count, alone.Diagnostics.Count));
    }

    [Fact]
    public void A_small_gap_is_a_warning_with_place_size_and_handle()
    {
        var result = Sequence(new DrawingBuilder().Line(0, 0, 10, 0).Line(10.25, 0, 90, 0), Nearest);

        var warnings = result.Diagnostics.Where(d => d.Severity == Severity.Warning).ToList();
        Assert.Equal(["SEQ0003", "SEQ0003"], warnings.Select(d => d.Id));
        Assert.StartsWith("The contour is open at 10, 0: the nearest other open end is 0.25 mm away, on entity A2.", warnings[0].Message, StringComparison.Ordinal);
        Assert.Equal("A1", warnings[0].Source.Handle);
        Assert.Equal(["SEQ0002", "SEQ0003", "SEQ0003", "SEQ0002"], result.Discontinuities.Select(end => end.DiagnosticId));
        Assert.Equal("A2", result.Discontinuities[1].NearestHandle);
    }

    [Fact]
    public void Duplicates_name_their_entity()
    {
        var result = Sequence(new DrawingBuilder().Circle(0, 0, 1).Circle(5, 0, 1).Circle(0, 0, 1), Nearest);

        var finding = Assert.Single(result.Diagnostics);
        Assert.StartsWith("Segments that coincide with another one are cut once: 1, the first is entity A3.", finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_empty_drawing_gives_an_empty_result_and_says_so()
    {
        var result = Sequence(new DrawingBuilder(), Nearest);

        Assert.Equal((0, 0.0, 0.0, 0.0), (result.Contours, result.Travel, result.TravelAndBack, result.TravelAsDrawn));
        Assert.Equal([SequencingRules.NothingToCut], result.Diagnostics.Select(d => d.Rule));
    }

    [Fact]
    public void Nests_deeper_than_a_thread_can_recurse_are_ordered_from_the_inside()
    {
        const int Depth = 200_000;
        var rings = Enumerable.Range(1, Depth).Select(radius => Segment.FromArc(new ArcSegment(default, radius, Angle.Zero, Angle.FullTurn))).ToArray();
        var contours = Enumerable.Range(0, Depth).Select(row => new Contour(new[] { new ContourPiece(row, Reversed: false) }, Closed: true)).ToArray();
        var inside = Enumerable.Range(1, Depth).Select(outer => outer < Depth ? outer : -1).ToArray();

        var order = TravelOrder.Drawn(contours, rings, inside, Point2D.Origin, first: null);

        Assert.Equal(Enumerable.Range(0, Depth), order.Select(entry => entry.Contour));
    }

    [Fact]
    public void Rules_have_ids_of_their_own() =>
        Assert.Equal(SequencingRules.All.Count, SequencingRules.All.Select(rule => rule.Id).Distinct().Count());

    private static SequencingResult Sequence(DrawingBuilder builder, SequencingOptions options)
    {
        var drawing = builder.Build();
        return Sequencer.Sequence(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), drawing, options);
    }

    private static Segment Half(double start) => Segment.FromArc(new ArcSegment(default, 10, Angle.FromDegrees(start), Angle.FromDegrees(180)));

    private static bool IsInsideFirst(int seed, SequencingOptions options)
    {
        var strokes = Sequence(NestedSquares(seed), options).Strokes;
        return strokes.All(stroke => stroke.Inside == -1 || stroke.Inside > stroke.Index) && strokes.Any(stroke => stroke.Inside >= 0);
    }

    private static bool IsJoined(SequencedStroke stroke) => stroke.Moves.Zip(stroke.Moves.Skip(1), (a, b) => a.Segment.End.IsNear(b.Segment.Start, 0.01)).All(joined => joined);

    /// <summary>Nested squares, some with a hole and an open line, in a random file order.</summary>
    private static DrawingBuilder NestedSquares(int seed)
    {
        var random = new Random(seed);
        var draw = new List<Action<DrawingBuilder>>();
        for (var stack = 0; stack < random.Next(1, 6); stack++)
        {
            var x = 200.0 * stack;
            for (var ring = 0; ring < random.Next(2, 6); ring++)
            {
                var inset = 10.0 * ring;
                draw.Add(builder => builder.Square(x + inset, inset, 100.0 - (2.0 * inset)));
            }

            draw.Add(builder => builder.Line(x + 46, 50, x + 54, 52));
        }

        var order = draw.ToArray();
        random.Shuffle(order);
        return order.Aggregate(new DrawingBuilder(), (builder, step) =>
        {
            step(builder);
            return builder;
        });
    }
}
