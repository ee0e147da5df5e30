using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Operations;

/// <summary>A plate of 40 x 40 with a window of 20 x 20 and an island of 6 x 6 in it on layer CUT, two holes of radius 1 and one of radius 2 on HOLES, a line
/// on MARK.</summary>
public class OperationStrokesTests
{
    private const string Outline = """{ "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 2 }""";

    [Fact]
    public void Every_curve_belongs_to_the_operations_that_name_it_and_the_rest_to_the_rest()
    {
        var job = new OperationJob(Plate(), """
            { "id": "a", "kind": "engrave", "select": {"layers": ["mark", "HOLES"]}, "tool": 1, "depth": 1 },
            { "id": "b", "kind": "engrave", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 1 },
            { "id": "c", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }
            """);

        Assert.Equal([4, 3, 12], job.Assignment.Parts.Select(part => part.Table.Count));
        Assert.Equal("OPR0007", Assert.Single(job.Assignment.Findings).Id);
        Assert.Equal("3", job.Assignment.Findings[0].Facts[2]);
        Assert.Empty(job.Assignment.NotTaken);
        Assert.Empty(job.Assignment.Faults);
    }

    [Fact]
    public void What_no_operation_takes_is_named_with_its_length_and_what_is_off_is_not_the_rest()
    {
        var job = new OperationJob(Plate(), """{ "id": "a", "on": false, "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1 }, { "id": "c", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""");

        Assert.Equal([6], job.Assignment.NotTaken);
        var finding = Assert.Single(job.Assignment.Findings);
        Assert.Equal(("OPR0008", "1", "10"), (finding.Id, finding.Facts[0], finding.Facts[1]));
    }

    [Theory]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": {"layers": ["MARX"]}, "tool": 1, "depth": 1 }""", "OPR0005")]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": {"handles": ["FFFF"]}, "tool": 1, "depth": 1 }""", "OPR0006")]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1 }""", "OPR0011")]
    [InlineData("""{ "id": "a", "on": false, "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""", "OPR0020")]
    [InlineData("""{ "id": "a", "on": false, "kind": "engrave", "select": {"layers": ["MARX"]}, "tool": 2, "depth": 1 }, { "id": "b", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""", "OPR0005")]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1, "feed": 1000000 }""", "OPR0003")]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1, "feed": 0.001 }""", "OPR0003")]
    [InlineData("""{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.0003 }""", "OPR0003")]
    public void Operations_that_do_not_fit_the_drawing_or_the_job_are_faults(string operations, string id) => Assert.Equal(id, Assert.Single(new OperationJob(Plate(), operations).Assignment.Faults).Id);

    /// <summary>Tools 1, 2, 2 and 1; the third operation takes nothing, and the order of the operations is kept.</summary>
    [Fact]
    public void A_job_has_a_section_for_every_change_of_the_tool()
    {
        var job = new OperationJob(Plate(), """
            { "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1, "depthPerPass": 0.5 },
            { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 2, "depth": 2 },
            { "id": "c", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 },
            { "id": "d", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 2, "depth": 1 },
            { "id": "e", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 2 }
            """);

        var sections = ToolSection.Of(job.Plan, job.Passes.Strokes);
        Assert.Equal(["1: a", "2: b d", "1: e"], sections.Select(section => FormattableString.Invariant($"{section.Tool.Number}: {string.Join(' ', section.Operations.Select(operation => operation.Id))}")));
        Assert.Equal([(0, 2), (2, 6), (6, 9)], sections.Select(section => (section.FirstStroke, section.EndStroke)));
        Assert.All(sections, section => Assert.All(section.Passes, pass => Assert.Equal(section.Tool.Number, pass.Operation.Tool)));
        Assert.Empty(job.Assignment.Faults);
        Assert.Empty(ToolSection.Of(job.Plan, []));
        Assert.Equal("1, 2", ToolSection.RefusalOfSeveral(sections)!.Facts[0]);
        Assert.Null(ToolSection.RefusalOfSeveral([sections[1]]));
    }

    /// <summary>Two contours of two passes and a finishing pass that is cut three times: each repeat cuts both contours, and is a section with what follows it
    /// with the same tool.</summary>
    [Theory]
    [InlineData("contour", "0.0 0.1 0.2 1.0 1.1 1.2")]
    [InlineData("level", "0.0 1.0 0.1 1.1 0.2 1.2")]
    public void A_stop_between_repeats_is_between_whole_repeats(string order, string before)
    {
        var operations = $$"""{ "id": "a", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 1, "repeats": 2 }, { "id": "b", "kind": "engrave", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 1, "depthPerPass": 0.5, "finish": 0.1, "repeats": 3, "order": "{{order}}", "stopBetween": true }, { "id": "c", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1 }""";
        var job = new OperationJob(new DrawingBuilder().OnLayer(Visible("CUT")).Square(0, 0, 40).Square(50, 0, 20).OnLayer(Visible("HOLES")).Circle(3, 3, 1).OnLayer(Visible("MARK")).Line(15, 5, 25, 5).Build(), operations);

        var sections = ToolSection.Of(job.Plan, job.Passes.Strokes);
        Assert.Equal([$"a 0.0 0.1 b {before}", "b 0.3 1.3", "b 0.4 1.4 c 0.0"], sections.Select(section => string.Join(' ', section.Passes.GroupBy(pass => pass.Operation.Id).Select(own => $"{own.Key} {string.Join(' ', own.Select(pass => $"{pass.Stroke}.{pass.Pass}"))}"))));
        Assert.Equal([null, 2, 3], sections.Select(section => section.Repeat));
        Assert.False(ToolSection.ChangesTool(sections));
        Assert.Equal(["b", "3"], ToolSection.RefusalOfSeveral(sections)!.Facts);
        Assert.Empty(job.CheckOf(job.Path));
        Assert.Single(ToolSection.Of(job.Plan, [.. sections[1].Passes]));
    }

    [Fact]
    public void Without_a_tool_axis_depths_and_holes_are_faults_and_strokes_are_flat()
    {
        var flat = MachineProfile.Default;

        Assert.Equal("OPR0010", Assert.Single(new OperationJob(Plate(), Outline, flat).Assignment.Faults).Id);
        var job = new OperationJob(Plate(), """{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "repeats": 2 }""", flat);
        Assert.Empty(job.Assignment.Faults);
        Assert.All(job.Path.Strokes.SelectMany(stroke => stroke.Moves), move => Assert.Equal((0.0, 0.0), (move.StartZ, move.EndZ)));
        Assert.Equal(2 * 7, job.Path.Strokes.Count);
    }

    [Fact]
    public void A_job_of_one_tool_runs_its_operations_and_the_others_keep_their_curves()
    {
        const string operations = """{ "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 2, "depth": 5 }, { "id": "b", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""";
        var job = new OperationJob(Plate(), operations.Replace("\"depth\": 5", "\"depth\": 3", StringComparison.Ordinal), tool: 2);

        Assert.Empty(job.Assignment.Faults);
        Assert.Equal(["a"], job.Passes.Strokes.Select(pass => pass.Operation.Id));
        Assert.Empty(job.Assignment.NotTaken);
        Assert.Empty(job.Assignment.Findings);
        Assert.Equal("OPR0013", Assert.Single(new OperationJob(Plate(), operations, tool: 2).Assignment.Faults).Id);
        Assert.Equal("OPR0020", Assert.Single(new OperationJob(Plate(), operations, tool: 3).Assignment.Faults).Id);
    }

    [Fact]
    public void A_profile_is_at_the_radius_of_its_tool_and_its_stock_on_the_side_of_each_level()
    {
        var job = new OperationJob(Plate(), """{ "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 2, "stock": 0.25 }""");
        var drawn = job.Assignment.Parts[0].Table.ToSegments();

        Assert.Empty(job.Shapes[0].Faults);
        Assert.Equal(3, job.Path.Strokes.Count);
        Assert.All(job.Path.Strokes.SelectMany(stroke => OperationJob.PointsOf(stroke, 0.1)), place => Assert.Equal(1.25, drawn.Min(segment => segment.DistanceTo(place)), 3));
        Assert.Equal([8.5, 17.5, 42.5], job.Path.Strokes.Select(stroke => OperationJob.PointsOf(stroke, 0.01)).Select(points => Math.Round(points.Max(place => place.X) - points.Min(place => place.X), 3)).Order());
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Theory]
    [InlineData("climb", true)]
    [InlineData("conventional", false)]
    public void Climb_is_clockwise_outside_and_counter_clockwise_in_holes(string direction, bool isClimb)
    {
        var job = new OperationJob(Plate(), $$"""{ "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 2, "direction": "{{direction}}" }""");

        foreach (var stroke in job.Path.Strokes)
        {
            var points = OperationJob.PointsOf(stroke, 0.5).ToList();
            var isHole = Math.Abs(OperationJob.AreaOf(points)) is > 200.0 and < 500.0; // the window
            Assert.Equal(isClimb != isHole, OperationJob.AreaOf(points) < 0.0);
        }

        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void An_open_contour_is_not_profiled_or_cleared()
    {
        foreach (var kind in (string[])["profile", "pocket"])
        {
            var job = new OperationJob(Plate(), $$"""{ "id": "a", "kind": "{{kind}}", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1 }""");
            Assert.Equal("OPR0016", Assert.Single(job.Shapes[0].Faults, fault => fault.Id == "OPR0016").Id);
        }
    }

    /// <summary>The area is tested point by point: everything that the tool can reach is swept, and nothing else.</summary>
    [Theory]
    [InlineData("", 0.0)]
    [InlineData(""", "zigzag": true, "angle": 30""", 0.0)]
    [InlineData(""", "stock": 0.5""", 0.5)]
    public void A_pocket_clears_what_its_tool_reaches_around_islands_and_nothing_else(string fields, double stock)
    {
        var job = new OperationJob(Plate(), $$"""{ "id": "p", "kind": "pocket", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 1{{fields}} }""");
        var walls = job.Assignment.Parts[0].Table.ToSegments();
        var moves = job.Path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment).ToList();

        Assert.Empty(job.Shapes[0].Faults);
        Assert.All(job.Path.Strokes.SelectMany(stroke => OperationJob.PointsOf(stroke, 0.2)), place => Assert.True(IsMaterial(place) && walls.Min(wall => wall.DistanceTo(place)) >= 1.0 + stock - 1e-6, $"{place}"));
        for (var x = -1.0; x < 42.0; x += 0.37)
        {
            for (var y = -1.0; y < 42.0; y += 0.41)
            {
                var place = new Point2D(x, y);
                var (toWall, isSwept) = (walls.Min(wall => wall.DistanceTo(place)), moves.Min(move => move.DistanceTo(place)) <= 1.0 + 1e-6);
                if (IsMaterial(place) && toWall >= 1.0 + stock) Assert.True(isSwept, $"{place} is left");
                if (!IsMaterial(place) && toWall > 1e-6) Assert.False(isSwept, $"{place} is cut");
            }
        }

        static bool IsMaterial(Point2D place) => Within(place, 0, 40) && (!Within(place, 10, 30) || Within(place, 17, 23));
    }

    /// <summary>Lines are parallel, at the spacing, as near to the walls as the inset, and none is missing.</summary>
    [Theory]
    [InlineData(0.0, 0.5, false)]
    [InlineData(30.0, 0.8, false)]
    [InlineData(90.0, 1.3, true)]
    public void A_fill_covers_the_inside_with_parallel_lines(double angle, double spacing, bool isCross)
    {
        var job = new OperationJob(Plate(), FormattableString.Invariant($$"""{ "id": "f", "kind": "fill", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 0.2, "spacing": {{spacing}}, "angle": {{angle}}, "inset": 0.7, "cross": {{(isCross ? "true" : "false")}} }"""));
        var walls = job.Assignment.Parts[0].Table.ToSegments();
        var lines = job.Path.Strokes.Select(stroke => Assert.Single(stroke.Moves).Segment).ToList();

        Assert.Empty(job.Shapes[0].Faults);
        Assert.Empty(job.CheckOf(job.Path));
        Assert.All(lines, line => Assert.True(walls.Min(wall => wall.DistanceTo(line.Start)) >= 0.7 - 1e-6 && walls.Min(wall => wall.DistanceTo(line.PointAt(0.5))) >= 0.7 - 1e-6 && IsMaterial(line.PointAt(0.5)), $"{line.Start} {line.End}"));
        foreach (var direction in isCross ? (double[])[angle, angle + 90.0] : [angle])
        {
            var across = Vector2D.FromPolar(1.0, Angle.FromDegrees(direction + 90.0));
            var own = lines.Where(line => Math.Abs(across.Dot(line.End - line.Start)) < 1e-6).ToList();
            for (var x = 0.2; x < 40.0; x += 0.77)
            {
                for (var y = 0.3; y < 40.0; y += 0.83)
                {
                    var place = new Point2D(x, y);
                    if (IsMaterial(place) && walls.Min(wall => wall.DistanceTo(place)) > 0.7 + (0.75 * spacing)) Assert.True(own.Min(line => line.DistanceTo(place)) <= (spacing / 2.0) + 1e-9, $"{place}");
                }
            }
        }

        static bool IsMaterial(Point2D place) => Within(place, 0, 40) && (!Within(place, 10, 30) || Within(place, 17, 23));
    }

    /// <summary>Every line is at the inset or a multiple of the spacing from it, and no place between is farther from a line than the spacing.</summary>
    [Theory]
    [InlineData(0.7, 1.5)]
    [InlineData(0.1, 2.0)]
    public void A_fill_parallel_to_the_contours_covers_the_inside(double inset, double spacing)
    {
        var job = new OperationJob(Plate(), FormattableString.Invariant($$"""{ "id": "f", "kind": "fill", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 0.2, "pattern": "contour", "spacing": {{spacing}}, "inset": {{inset}} }"""));
        var walls = job.Assignment.Parts[0].Table.ToSegments();
        var lines = job.Path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment).ToList();

        Assert.Empty(job.Shapes[0].Faults);
        Assert.Empty(job.CheckOf(job.Path));
        Assert.All(job.Path.Strokes, stroke => Assert.True(stroke.Closed));
        Assert.All(job.Path.Strokes.SelectMany(stroke => OperationJob.PointsOf(stroke, 0.3)), place => Assert.True(Math.Abs(Math.IEEERemainder(walls.Min(wall => wall.DistanceTo(place)) - inset, spacing)) < 1e-3 && IsMaterial(place), $"{place}"));
        for (var x = 0.2; x < 40.0; x += 0.77)
        {
            for (var y = 0.3; y < 40.0; y += 0.83)
            {
                var place = new Point2D(x, y);
                if (IsMaterial(place) && walls.Min(wall => wall.DistanceTo(place)) >= inset) Assert.True(lines.Min(line => line.DistanceTo(place)) <= spacing, $"{place}");
            }
        }

        static bool IsMaterial(Point2D place) => Within(place, 0, 40) && (!Within(place, 10, 30) || Within(place, 17, 23));
    }

    /// <summary>Its inset is larger than half of the narrow contour; the wide one has lines, and no line is reported as an open contour.</summary>
    [Fact]
    public void A_contour_without_a_line_is_named()
    {
        var drawing = new DrawingBuilder().Square(0, 0, 20).Square(30, 0, 1).Build();
        var job = new OperationJob(drawing, """{ "id": "f", "kind": "fill", "select": "rest", "tool": 1, "depth": 0.2, "spacing": 0.5 }""");

        var finding = Assert.Single(job.Shapes[0].Findings);
        Assert.Equal(("OPR0024", "1", "30"), (finding.Id, finding.Facts[1], finding.Facts[2]));
        Assert.NotEmpty(job.Path.Strokes);
        Assert.Empty(job.Ordered[0].Diagnostics);
    }

    [Fact]
    public void Each_hole_is_drilled_once_straight_down_in_pecks()
    {
        var job = new OperationJob(Plate(), """{ "id": "h", "kind": "drill", "select": {"layers": ["HOLES", "MARK"]}, "tool": 1, "startDepth": 0.5, "depth": 3, "peck": 1, "maxDiameter": 2 }""");

        Assert.Equal(["OPR0019"], job.Shapes[0].Findings.Select(finding => finding.Id));
        Assert.Equal("2", job.Shapes[0].Findings[0].Facts[1]);
        Assert.Equal([new Point2D(3, 3), new Point2D(37, 3)], job.Path.Strokes.Select(stroke => stroke.Start));
        foreach (var stroke in job.Path.Strokes)
        {
            Assert.All(stroke.Moves, move => Assert.Equal((stroke.Start, stroke.Start), (move.Segment.Start, move.Segment.End)));
            Assert.Equal([-0.5, -1.333333, -0.5, -2.166667, -0.5, -3.0], stroke.Moves.Select(move => Math.Round(move.EndZ, 6)).Prepend(Math.Round(stroke.Moves[0].StartZ, 6)));
        }

        Assert.Empty(job.CheckOf(job.Path));
    }

    [Theory]
    [InlineData("contour", "-1 -2 -1 -2 -1 -2")]
    [InlineData("level", "-1 -1 -1 -2 -2 -2")]
    public void Passes_follow_each_other_by_contour_or_by_level(string order, string expected)
    {
        var job = new OperationJob(Plate(), $$"""{ "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 2, "depthPerPass": 1, "order": "{{order}}" }""");

        Assert.Equal(expected, string.Join(' ', job.Path.Strokes.Select(stroke => stroke.Moves[0].StartZ)));
        Assert.All(job.Passes.Sequence.Strokes.Zip(job.Passes.Strokes), pair => Assert.True(pair.First.Inside < 0 || (pair.First.Inside > pair.First.Index && job.Passes.Strokes[pair.First.Inside].Pass == pair.Second.Pass)));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void Operations_are_cut_in_their_order()
    {
        var job = new OperationJob(Plate(), $$"""{ "id": "h", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 1 }, {{Outline}}, { "id": "m", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1 }""");

        Assert.Equal(["h", "h", "h", "cut", "cut", "cut", "m"], job.Passes.Strokes.Select(pass => pass.Operation.Id));
        Assert.Equal(Enumerable.Range(1, job.Passes.Sequence.Table.Count), Enumerable.Range(0, job.Passes.Sequence.Table.Count).Select(row => job.Passes.Sequence.Table[row].SequenceNumber));
    }

    [Fact]
    public void The_machine_of_a_job_has_the_heights_of_the_operations()
    {
        var machine = new MachineProfile { Height = new HeightDrive { CutDepth = 7.0, DepthPerPass = 1.0, PlungeMmPerMinute = 300.0 } };
        var plan = new OperationJob(Plate(), """{ "id": "a", "kind": "engrave", "select": "rest", "tool": 2, "depth": 1 }, { "id": "b", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1, "plunge": 50 }""").Plan;

        var applied = plan.Applied(machine, 0);
        Assert.Equal((0.0, null, 300.0), (applied.Height!.CutDepth, applied.Height.DepthPerPass, applied.Height.PlungeMmPerMinute));
        Assert.Equal(900.0, new OperationJob(Plate(), """{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1, "feed": 400 }, { "id": "b", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1, "feed": 900 }""").Plan.Applied(machine, 0).FeedMmPerMinute);
        Assert.Equal(300.0, plan.Applied(machine, 2).Height!.PlungeMmPerMinute);
        Assert.Equal(applied, plan.Applied(applied, 0));
    }

    [Fact]
    public void The_check_finds_a_stroke_without_the_wait_of_its_operation()
    {
        var job = new OperationJob(Plate(), """{ "id": "m", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 1, "pierce": 0.5 }""");

        Assert.Equal(["OPR0018"], job.CheckOf(job.Path));
        Assert.Empty(job.CheckOf(job.Path with { Strokes = [.. job.Path.Strokes.Select(stroke => stroke with { PierceSeconds = 0.5 })] }));
    }

    [Fact]
    public void A_plunge_feed_that_the_machine_cannot_count_is_refused() =>
        Assert.Contains(new OperationJob(Plate(), """{ "id": "m", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1, "plunge": 0.1 }""").Assignment.Faults, fault => fault.Id == "OPR0003" && fault.Facts[0] == "m: plunge");

    private static bool Within(Point2D place, double from, double to) => place.X > from && place.X < to && place.Y > from && place.Y < to;

    internal static Drawing Plate() => new DrawingBuilder()
        .OnLayer(Visible("CUT")).Square(0, 0, 40).Square(10, 10, 20).Square(17, 17, 6)
        .OnLayer(Visible("HOLES")).Circle(3, 3, 1).Circle(37, 3, 1).Circle(37, 37, 2)
        .OnLayer(Visible("MARK")).Line(15, 5, 25, 5).Build();

    private static Layer Visible(string name) => new(name, On: true, Frozen: false, Plot: true);
}
