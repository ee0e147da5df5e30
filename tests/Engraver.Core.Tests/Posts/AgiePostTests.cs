using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Posts.Agie;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Posts;

/// <summary>Paper 000, Table 1, and sace-xps-agie.md 4.3 to 4.5.</summary>
public class AgiePostTests
{
    private const double ContourError = 0.0011;

    private static readonly double s_belt = Math.Acos(5.0 / 30.0) * 180.0 / Math.PI;

    /// <summary>The paper prints blocks 1 to 6 and 441 to 443 of its test component; here other blocks are between them.</summary>
    [Fact]
    public void The_nine_rows_of_the_papers_table_come_from_the_segments_they_stand_for()
    {
        var place = default(Point2D);
        var drawn = new List<Segment>();
        void Line(double x, double y) => Add(Segment.FromLine(place, place + new Vector2D(x, y)));
        void Arc(double radius, double start, double sweep) => Add(Segment.FromArc(new ArcSegment(place - Vector2D.FromPolar(radius, Angle.FromDegrees(start)), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep))));
        void Add(Segment segment)
        {
            drawn.Add(segment);
            place = segment.End;
        }

        Arc(0.4, 180, 60);
        Arc(0.4, 210, 60);
        Line(20.835, -5.788);
        Line(0.752, 0.599);
        Arc(2.69, 247, 53);
        Arc(2.361, 300, 1);
        for (var filler = 7; filler <= 440; filler++) Line(0.001 * filler, 0.002);
        Line(-0.866, -0.418);
        Arc(31, 28, 8);
        Arc(5.207, 36, 1);
        var rows = Written(Path([.. drawn]), "paper").Text.Split('\n');

        string[] printed =
        [
            "%\t001\t03\t180\t060\t+000400\t+000400\t02", "\t002\t03\t210\t060\t+000400\t+000400\t02", "\t003\t01\t000\t000\t+020835\t-005788\t02",
            "\t004\t01\t000\t000\t+000752\t+000599\t02", "\t005\t03\t247\t053\t+002690\t+002690\t02", "\t006\t03\t300\t001\t+002361\t+002361\t02",
            "\t441\t01\t000\t000\t-000866\t-000418\t02", "\t442\t03\t028\t008\t+031000\t+031000\t02", "\t443\t03\t036\t001\t+005207\t+005207\t02\t02",
        ];
        string[] found = [.. rows[..6], .. rows[440..443]];
        Assert.Equal(printed, found);
        Assert.Equal("", Assert.Single(rows[443..]));
    }

    [Theory]
    [InlineData("paper")]
    [InlineData("exact")]
    public void Worked_example_A_is_the_same_in_both_styles(string style)
    {
        var slot = new[] { Line(-2, 0, 0, 0), Line(0, 0, 20, 0), Arc(20, 5, 5, 270, 180), Line(20, 10, 0, 10), Line(0, 10, 0, 0) };
        var hole = new[] { Line(50, 0, 52, 0), Arc(55, 0, 3, 180, -360) };
        var written = Written(Path(slot, hole), style);

        Assert.Equal(
            "%\t001\t01\t000\t000\t+002000\t+000000\t02\n\t002\t01\t000\t000\t+020000\t+000000\t02\n\t003\t03\t270\t180\t+005000\t+005000\t02\n\t004\t01\t000\t000\t-020000\t+000000\t02\n\t005\t01\t000\t000\t+000000\t-010000\t02\n\t006\t01\t000\t000\t+050000\t+000000\t01\n\t007\t01\t000\t000\t+002000\t+000000\t02\n\t008\t02\t180\t180\t+003000\t+003000\t02\n\t009\t02\t000\t180\t+003000\t+003000\t02\t02\n",
            written.Text);
        Assert.Empty(written.Diagnostics);
        Assert.Equal(new Point2D(50, 0), written.Forecast!.Blocks[5].End);
        Assert.Equal((null, false), (written.Forecast.Blocks[5].Error, written.Forecast.Blocks[5].Cutting));
        Assert.InRange(written.Forecast.MaxError, 0.0, 1e-9);
        Assert.InRange(written.Forecast.Blocks[4].Closure!.Value, 0.0, 1e-9);
    }

    [Fact]
    public void Worked_example_B_is_exact_in_ten_blocks()
    {
        var written = Written(Path(Belt()), "exact");

        Assert.Equal(
            "%\t001\t01\t000\t000\t-000333\t-001972\t02\n\t002\t01\t000\t000\t-000103\t+000017\t02\n\t003\t03\t081\t180\t+010000\t+010000\t02\n\t004\t03\t261\t018\t+010000\t+010000\t02\n\t005\t01\t000\t000\t+000103\t+000016\t02\n\t006\t01\t000\t000\t+029166\t+004931\t02\n\t007\t01\t000\t000\t+000035\t+000006\t02\n\t008\t03\t280\t160\t+005000\t+005000\t02\n\t009\t01\t000\t000\t-000035\t+000006\t02\n\t010\t01\t000\t000\t-029166\t+004930\t02\t02\n",
            written.Text);
        Assert.Equal(0.5, 1000.0 * written.Forecast!.MaxError, 0.05);
        Assert.Equal(0.47, 1000.0 * written.Forecast.MaxClosure!.Value, 0.005);
    }

    [Fact]
    public void Worked_example_B_in_whole_degrees_says_how_far_off_it_is()
    {
        var written = Written(Path(Belt()), "paper");

        Assert.Contains("\t080\t199\t", written.Text, StringComparison.Ordinal);
        Assert.Contains("\t280\t161\t", written.Text, StringComparison.Ordinal);
        Assert.Equal(206.7, 1000.0 * written.Forecast!.MaxError, 0.05);
        Assert.Equal(257.9, 1000.0 * written.Forecast.MaxClosure!.Value, 0.05);
        Assert.Equal("PST0004", Assert.Single(written.Diagnostics).Id);
    }

    /// <summary>Regression: a belt that is cut first and then left by its entry line was reported as closed, and was not.</summary>
    [Fact]
    public void A_contour_that_is_left_by_a_line_is_held_against_where_it_came_back()
    {
        Segment[] left = [.. Belt().Skip(1), Segment.FromLine(Belt()[0].End, Belt()[0].Start)];
        var written = Written(Path(left), "paper");

        Assert.InRange(1000.0 * written.Forecast!.MaxClosure!.Value, 100.0, 1000.0);
        Assert.Null(written.Forecast.Blocks[^1].Closure);
        Assert.NotNull(written.Forecast.Blocks[^2].Closure);
        Assert.Contains("closed contour is 0.", Assert.Single(written.Diagnostics).Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public void Where_nothing_comes_back_no_closure_is_told()
    {
        var written = Written(Path(new[] { Arc(0, 0, 31, 0.5, 60) }), "paper");

        Assert.Null(written.Forecast!.MaxClosure);
        Assert.Contains("the program has no closed contour", Assert.Single(written.Diagnostics).Sentence, StringComparison.Ordinal);
    }

    /// <summary>Contours of arcs of any radius and angle, each starting at the end of the previous one; the machine is followed by separate
    /// arithmetic.</summary>
    [Fact]
    public void The_exact_style_never_leaves_the_path_by_more_than_it_promises()
    {
        var random = new Random(15);
        var (worst, worstEnd) = (0.0, 0.0);
        for (var contour = 0; contour < 150; contour++)
        {
            var (place, drawn) = (new Point2D(random.NextDouble() * 100.0, random.NextDouble() * 100.0), new List<Segment>());
            for (var i = 0; i < 8; i++)
            {
                var (radius, start, sweep) = (Math.Pow(10.0, (random.NextDouble() * 4.0) - 1.5), random.NextDouble() * 360.0, (random.NextDouble() - 0.5) * 719.0);
                if (i % 3 == 0) start = Math.Round(start);
                if (i % 4 == 0) radius = Math.Round(radius, 3) + (i % 8 == 0 ? 0.0005 : 0.0);
                drawn.Add(Segment.FromArc(new ArcSegment(place - Vector2D.FromPolar(radius, Angle.FromDegrees(start)), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep))));
                place = drawn[^1].End;
            }

            var written = Written(Path([.. drawn]), "exact");
            var run = TabProgram.Paths(written.Text, drawn[0].Start)!;
            worst = Math.Max(worst, run.Max(block => Enumerable.Range(0, 65).Max(at => drawn.Min(segment => segment.DistanceTo(block.Path.PointAt(at / 64.0))))));
            worstEnd = Math.Max(worstEnd, run[^1].Path.End.DistanceTo(place));
            Assert.InRange(written.Forecast!.MaxError, 0.0, ContourError);
        }

        Assert.InRange(worst, 0.0003, ContourError);
        Assert.InRange(worstEnd, 0.0, ContourError);
    }

    [Fact]
    public void A_line_that_six_digits_do_not_hold_is_split_evenly()
    {
        var run = TabProgram.Paths(Written(Path([Line(0, 0, 2500.001, -1.0)]), "exact").Text, default)!;

        Assert.Equal(3, run.Count);
        Assert.All(run, block => Assert.InRange(block.Path.Length, 833.0, 834.0));
        Assert.InRange(run[^1].Path.End.DistanceTo(new Point2D(2500.001, -1.0)), 0.0, 1e-6);
    }

    [Fact]
    public void An_arc_too_large_or_too_small_for_the_form_is_cut_in_chords_or_refused_in_the_papers_style()
    {
        var large = Arc(0, -2000, 2000, 90, -1.3);
        var small = Arc(0, 0, 0.0003, 20, 300);
        var written = Written(Path([large]), "exact");

        Assert.DoesNotContain("\t02\t090", written.Text, StringComparison.Ordinal);
        Assert.InRange(written.Forecast!.MaxError, 0.0, ContourError);
        Assert.Equal("PST0005", Assert.Single(Written(Path([large]), "paper").Diagnostics).Id);
        Assert.Equal("PST0005", Assert.Single(Written(Path([small]), "paper").Diagnostics).Id);
        Assert.Empty(Written(Path([small]), "paper").Chunks);
    }

    [Fact]
    public void What_is_longer_than_its_numbers_is_parted_between_contours_where_it_can_be()
    {
        Segment[] Zigzag(int count, double x) => [.. Enumerable.Range(0, count).Select(i => Line(x + i, i % 2, x + i + 1, (i + 1) % 2))];
        var written = Written(Path(Zigzag(600, 0), Zigzag(500, 700), Zigzag(1200, 1300)), "exact");
        var counts = written.Chunks.Select(chunk => chunk.Count(letter => letter == '\n')).ToArray();

        Assert.Equal([600, 501, 999, 202], counts);
        Assert.All(written.Chunks, chunk => Assert.True(chunk.StartsWith("%\t001\t", StringComparison.Ordinal) && chunk.EndsWith("\t02\t02\n", StringComparison.Ordinal)));
        Assert.Equal("PST0002", Assert.Single(written.Diagnostics).Id);
        Assert.Equal((4, 202), (written.Forecast!.Blocks[^1].Part, written.Forecast.Blocks[^1].Number));
    }

    [Fact]
    public void A_job_without_end_or_without_size_is_refused()
    {
        Assert.Equal("PST0003", Assert.Single(Written(Path([Line(0, 0, 1e9, 0)]), "exact").Diagnostics).Id);
        Assert.Equal("PST0003", Assert.Single(Written(Path([Line(0, 0, 1e300, 0)]), "paper").Diagnostics).Id);
        Assert.Equal("PST0006", Assert.Single(Written(Path([Line(0, 0, 0.0001, 0)]), "exact").Diagnostics).Id);
        Assert.Equal("DOC0002", Assert.Single(Written(Path(), "exact").Diagnostics).Id);
    }

    [Fact]
    public void The_mark_of_the_start_may_have_a_line_of_its_own()
    {
        var options = new Dictionary<string, string> { ["start-mark"] = "own-line" };
        var text = new AgiePost().Write(UsualOptions.Post(Path([Line(0, 0, 1, 0)]), null, null, options)).Text;

        Assert.Equal("%\n\t001\t01\t000\t000\t+001000\t+000000\t02\t02\n", text);
    }

    [Fact]
    public void A_gap_within_the_join_tolerance_is_bridged_and_the_next_line_begins_where_it_is_drawn()
    {
        var written = Written(Path([Line(0, 0, 10, 0), Line(10.008, 0.004, 20, 0.004)]), "exact");

        Assert.Equal("%\t001\t01\t000\t000\t+010000\t+000000\t02\n\t002\t01\t000\t000\t+000008\t+000004\t02\n\t003\t01\t000\t000\t+009992\t+000000\t02\t02\n", written.Text);
    }

    private static Segment[] Belt()
    {
        var (large, small) = (Arc(0, 0, 10, s_belt, 360.0 - (2.0 * s_belt)), Arc(30, 0, 5, 360.0 - s_belt, 2.0 * s_belt));
        var entry = default(Point2D) + Vector2D.FromPolar(12.0, Angle.FromDegrees(s_belt));
        return [Segment.FromLine(entry, large.Start), large, Segment.FromLine(large.End, small.Start), small, Segment.FromLine(small.End, large.Start)];
    }

    private static PostOutput Written(Toolpath path, string style) => new AgiePost().Write(UsualOptions.Post(path, null, null, new Dictionary<string, string> { ["style"] = style }));

    private static Toolpath Path(params Segment[][] strokes) => new(default, [.. strokes.Select((segments, index) => new ToolpathStroke(index, segments[0].Start == segments[^1].End, [.. segments.Select((segment, entity) => new StrokeMove(segment, entity))]))]);

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static Segment Arc(double x, double y, double radius, double start, double sweep) => Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));
}
