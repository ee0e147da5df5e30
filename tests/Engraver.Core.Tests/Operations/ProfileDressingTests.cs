using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Operations;

/// <summary>Starts, leads and tabs of closed profiles.</summary>
public class ProfileDressingTests
{
    private const double Radius = 1.0;

    private const string Dressed = """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 1.5, "direction": "climb", "start": {"rule": "longest"}, "leadIn": {"shape": "arc", "radius": 2}, "leadOut": {"shape": "line", "length": 1.5}, "tabs": {"count": 3, "width": 2, "height": 1} }""";

    private static readonly double s_rampSlope = Math.Tan(6.0 * Math.PI / 180.0);

    private static readonly string[] s_variants =
    [
        Dressed,
        """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 1.5, "direction": "climb", "start": {"rule": "corner"}, "ramp": {"angle": 6}, "leadIn": {"shape": "line", "length": 2, "direction": "tangential"}, "tabs": {"count": 3, "width": 2, "height": 1, "shape": "sloped", "angle": 64} }""",
        """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 2, "direction": "climb", "start": {"rule": "top"}, "ramp": {"angle": 6}, "overcut": 3, "leadIn": {"shape": "arc", "radius": 1.5}, "leadOut": {"shape": "arc", "radius": 2}, "tabs": {"spacing": 45, "width": 2, "height": 1} }""",
        """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 1.5, "direction": "climb", "start": {"rule": "longest"}, "ramp": {"angle": 6, "radius": 2}, "leadIn": {"shape": "line", "length": 1}, "tabs": {"count": 3, "width": 2, "height": 1} }""",
    ];

    [Fact]
    public void A_lead_is_tangent_in_the_waste_and_a_tab_is_as_wide_and_high_as_stated()
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 40).Build(), Dressed);
        var (rough, last) = (job.Path.Strokes[0], job.Path.Strokes[1]);

        Assert.Empty(job.Passes.Findings);
        Assert.Empty(job.CheckOf(job.Path));
        var lead = last.Moves[0];
        Assert.Equal((StrokeRole.Lead, SegmentKind.Arc, 2.0), (lead.Role, lead.Segment.Kind, lead.Segment.Arc.Radius));
        Assert.Equal(0.0, lead.Segment.EndTangent.TurnTo(last.Moves[1].Segment.StartTangent).Degrees, 9);
        Assert.Equal((StrokeRole.Lead, 1.5), (last.Moves[^1].Role, Math.Round(last.Moves[^1].Segment.Length, 9)));
        Assert.DoesNotContain(rough.Moves, move => move.Role == StrokeRole.Tab); // 1.5 mm deep, the tabs begin at 2 mm
        var tabs = last.Moves.Where(move => move.Role == StrokeRole.Tab && move.Segment.Length > 0.0).ToList();
        Assert.Equal([(4.0, -2.0), (4.0, -2.0), (4.0, -2.0)], tabs.Select(tab => (Math.Round(tab.Segment.Length, 9), tab.StartZ)));
        Assert.All(last.Moves.Where(move => move.Role == StrokeRole.Cut), move => Assert.Equal((-3.0, -3.0), (move.StartZ, move.EndZ)));
    }

    [Theory]
    [InlineData("longest", -1.0, 20.0)]
    [InlineData("top", 20.0, 41.0)]
    public void The_start_is_in_the_middle_of_its_side(string rule, double x, double y)
    {
        var drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, Line(0, 0, 40, 0), Line(40, 0, 40, 40), Line(40, 40, 0, 40), Line(0, 40, 0, 0)).Build();
        if (rule == "longest") drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, Line(0, 0, 30, 0), Line(30, 0, 30, 40), Line(30, 40, 0, 40), Line(0, 40, 0, 0)).Build();
        var start = new OperationJob(drawing, $$"""{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "start": {"rule": "{{rule}}"} }""").Path.Strokes[0].Start;

        Assert.True(start.DistanceTo(new Point2D(x, y)) < 1e-9 || (rule == "longest" && start.DistanceTo(new Point2D(31.0, y)) < 1e-9), $"{start}");
    }

    /// <summary>The corner of the drawing is inside of the arc around it, or where two sides of a hole meet; the sharpest one is taken.</summary>
    [Theory]
    [InlineData("outside", 30.0 + 0.92388, -0.38268)] // in the middle of the arc around it
    [InlineData("inside", 30.0 - 2.41421, 1.0)] // where the path is 1 mm from both sides
    public void The_start_is_at_the_sharpest_corner(string side, double x, double y)
    {
        // A trapezoid with angles of 90, 90, 135 and 45 degrees, the last at 30, 0.
        var drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, Line(0, 0, 30, 0), Line(30, 0, 20, 10), Line(20, 10, 0, 10), Line(0, 10, 0, 0)).Circle(60, 0, 5).Build();
        var job = new OperationJob(drawing, $$"""{ "id": "cut", "kind": "profile", "side": "{{side}}", "select": "rest", "tool": 1, "depth": 3, "start": {"rule": "corner"} }""");
        var start = job.Path.Strokes.Single(stroke => stroke.Start.X < 40.0).Start;

        Assert.True(start.DistanceTo(new Point2D(x, y)) < 1e-4, $"{start}");
        Assert.Equal(("OPR0051", "1"), (Assert.Single(job.Passes.Findings).Id, job.Passes.Findings[0].Facts[1]));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void A_picked_start_belongs_to_the_nearest_contour_and_one_without_is_named()
    {
        var drawing = new DrawingBuilder().Square(0, 0, 20).Square(23, 0, 20).Circle(70, 10, 5).Build();
        var job = new OperationJob(drawing, """{ "id": "cut", "kind": "profile", "side": "outside", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 2, "start": {"rule": "top", "at": [[9, 0], [20.5, 7], [75, 10], [70, 40]], "within": 4} }""");

        Assert.Equal([(10.0, 21.0, 7.0), (33.0, 33.0, 21.0), (70.0, 76.0, 10.0)], job.Path.Strokes.Where((_, index) => job.Passes.Strokes[index].Pass == 1).Select(stroke => (Math.Round((stroke.Moves.Min(move => move.Segment.Bounds.MinX) + stroke.Moves.Max(move => move.Segment.Bounds.MaxX)) / 2.0, 6), Math.Round(stroke.Start.X, 6), Math.Round(stroke.Start.Y, 6))).Order());
        var finding = Assert.Single(job.Passes.Findings);
        Assert.Equal(("OPR0050", "2", "70"), (finding.Id, finding.Facts[1], finding.Facts[2]));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Theory]
    [InlineData("\"spacing\": 30", 6)] // 4 sides of 40 mm and 4 quarters of the radius: 166.3 mm
    [InlineData("\"spacing\": 500", 1)]
    [InlineData("\"at\": [[20, 0], [40, 11], [38.9, 40.9]]", 3)]
    [InlineData("\"count\": 2, \"at\": [[20, 0]]", 3)]
    [InlineData("\"count\": 40", 24)] // as many as fit at one and a half times the span of 4 mm
    public void Tabs_are_by_count_by_spacing_or_by_hand(string tabs, int count)
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 40).Build(), $$"""{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "tabs": { {{tabs}}, "width": 2, "height": 1} }""");
        var middles = job.Path.Strokes[0].Moves.Where(move => move.Role == StrokeRole.Tab && move.Segment.Length > 0.0).Select(tab => tab.Segment.PointAt(0.5)).ToList();

        Assert.Equal(count, middles.Count);
        Assert.Empty(job.CheckOf(job.Path));
        Assert.Equal(count == 24 ? ["OPR0023"] : [], job.Passes.Findings.Select(finding => finding.Id));
        if (tabs.Contains("at", StringComparison.Ordinal)) Assert.Contains(middles, middle => middle.DistanceTo(new Point2D(20.0, -1.0)) < 1e-6);
        if (count == 3 && !tabs.Contains("count", StringComparison.Ordinal)) Assert.Contains(middles, middle => middle.DistanceTo(new Point2D(37.0, 41.0)) < 1e-6); // away from the corner
    }

    [Fact]
    public void A_picked_tab_without_room_is_named()
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 40).Circle(80, 0, 4).Build(), """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "tabs": {"at": [[20, 0], [20.5, 0], [80, 5], [100, 100]], "within": 5, "width": 2, "height": 1} }""");

        var finding = Assert.Single(job.Passes.Findings);
        Assert.Equal(("OPR0052", "3", "100"), (finding.Id, finding.Facts[1], finding.Facts[2]));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void A_lead_without_room_is_shortened_or_left_out_and_named()
    {
        // A window of 2.1 mm leaves a tool of 2 mm no room for a lead. A gap of 3 mm between two squares leaves it 1 mm.
        var slot = new OperationJob(new DrawingBuilder().Square(0, 0, 2.1).Build(), """{ "id": "cut", "kind": "profile", "side": "inside", "select": "rest", "tool": 1, "depth": 3, "leadIn": {"shape": "arc", "radius": 2} }""");
        var gap = new OperationJob(new DrawingBuilder().Square(0, 0, 20).Square(23, 0, 20).Build(), """{ "id": "cut", "kind": "profile", "side": "outside", "select": "rest", "tool": 1, "depth": 3, "leadIn": {"shape": "line", "length": 30} }""");

        Assert.Contains("OPR0021", slot.Passes.Findings.Select(finding => finding.Id));
        Assert.DoesNotContain(slot.Path.Strokes[0].Moves, move => move.Role == StrokeRole.Lead);
        Assert.Empty(slot.CheckOf(slot.Path));
        Assert.All(gap.Path.Strokes, stroke => Assert.All(OperationJob.PointsOf(stroke, 0.05), place => Assert.True(DistanceToSquares(place) >= Radius - 1e-3, $"{place}")));

        static double DistanceToSquares(Point2D place) => Math.Min(ToSquare(place, 0, 0, 20), ToSquare(place, 23, 0, 20));
    }

    [Theory]
    [InlineData(2.0, 8.0)] // the part beside it belongs to another tool
    [InlineData(0.01, 5.0)] // a tool that is thinner than the steps of a search along the lead
    public void A_lead_keeps_away_from_the_parts_of_every_tool(double diameter, double length)
    {
        var drawing = new DrawingBuilder().OnLayer(Visible("A")).Square(0, 0, 20).OnLayer(Visible("B")).Square(20.0 + (diameter / 2.0) + 0.6, 0, 30).Build();
        var read = FormattableString.Invariant($$"""{ "id": "a", "kind": "profile", "side": "outside", "select": {"layers": ["A"]}, "tool": 1, "depth": 1, "leadIn": {"shape": "line", "length": {{length}}} }, { "id": "b", "kind": "profile", "side": "outside", "select": {"layers": ["B"]}, "tool": 2, "depth": 1 }""");
        foreach (var start in (string[])["nearest", "longest", "top"])
        {
            var job = new OperationJob(drawing, read.Replace("\"leadIn\"", "\"start\": {\"rule\": \"" + start + "\"}, \"leadIn\"", StringComparison.Ordinal), tool: 1, diameter: diameter);
            Assert.All(job.Path.Strokes.SelectMany(stroke => stroke.Moves).Where(move => move.Role == StrokeRole.Lead), move => Assert.All(Enumerable.Range(0, 2001), step => Assert.True(ToSquare(move.Segment.PointAt(step / 2000.0), 20.0 + (diameter / 2.0) + 0.6, 0, 30) >= (diameter / 2.0 * 0.98) - 2e-4, $"{start} {move.Segment.Start}")));
        }
    }

    /// <summary>A tangential line begins before the corner, in line with the first side.</summary>
    [Fact]
    public void A_line_is_perpendicular_or_tangential()
    {
        Segment Lead(string direction) => new OperationJob(new DrawingBuilder().Square(0, 0, 20).Build(), $$"""{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 1, "direction": "climb", "start": {"rule": "top"}, "leadIn": {"shape": "line", "length": 3{{direction}}} }""").Path.Strokes[0].Moves[0].Segment;

        Assert.Equal((10.0, 24.0, 10.0, 21.0), Ends(Lead("")));
        Assert.Equal((7.0, 21.0, 10.0, 21.0), Ends(Lead(", \"direction\": \"tangential\"")));

        static (double, double, double, double) Ends(Segment line) => (Math.Round(line.Start.X, 9), Math.Round(line.Start.Y, 9), Math.Round(line.End.X, 9), Math.Round(line.End.Y, 9));
    }

    [Fact]
    public void An_open_contour_beside_a_line_has_leads_on_the_far_side()
    {
        var job = new OperationJob(new DrawingBuilder().Line(0, 0, 30, 0).Build(), """{ "id": "cut", "kind": "profile", "side": "left", "select": "rest", "tool": 1, "depth": 2, "depthPerPass": 1, "overcut": 2, "leadIn": {"shape": "arc", "radius": 2}, "leadOut": {"shape": "line", "length": 3} }""");

        Assert.Empty(job.CheckOf(job.Path));
        Assert.Empty(job.Passes.Findings);
        Assert.All(job.Path.Strokes, stroke => Assert.Equal([StrokeRole.Lead, StrokeRole.Cut, StrokeRole.Lead], stroke.Moves.Select(move => move.Role)));
        Assert.Equal((3.0, 4.0), (Math.Round(job.Path.Strokes[0].Start.Y, 6), Math.Round(job.Path.Strokes[0].End.Y, 6)));
    }

    [Theory]
    [InlineData("nearest", 5.0)]
    [InlineData("longest", 30.0)] // beyond the first corner
    public void An_overcut_repeats_the_beginning_of_the_contour(string start, double overcut)
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 40).Build(), FormattableString.Invariant($$"""{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "start": {"rule": "{{start}}"}, "overcut": {{overcut}}, "leadOut": {"shape": "line", "length": 3}, "tabs": {"spacing": 20, "width": 2, "height": 1} }"""));
        var stroke = job.Path.Strokes[0];
        var contour = (4 * 40.0) + (2.0 * Math.PI);

        Assert.Empty(job.CheckOf(job.Path));
        Assert.Equal(contour + overcut + 3.0, stroke.Length, 6);
        Assert.False(stroke.Closed);
        Assert.Equal(9, job.Passes.Places[0].Tabs.Count);
        Assert.All(job.Passes.Places[0].Tabs, tab => Assert.True(stroke.Moves[^2].Segment.DistanceTo(tab) > 2.9));
        Assert.NotEmpty(job.CheckOf(job.Path with { Strokes = [stroke with { Moves = [.. stroke.Moves.SkipLast(2)] }] }));
        Assert.Equal("OPR0053", Assert.Single(new OperationJob(new DrawingBuilder().Square(0, 0, 4).Build(), """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "overcut": 50 }""").Passes.Findings).Id);
    }

    /// <summary>The tool is at the depth before at the start of the ramp, never falls more steeply than stated, and then cuts the whole contour.</summary>
    [Theory]
    [InlineData("profile", "CUT", "\"direction\": \"climb\", \"tabs\": {\"count\": 2, \"width\": 2, \"height\": 1}, \"leadIn\": {\"shape\": \"arc\", \"radius\": 2},")]
    [InlineData("profile", "HOLES", "")] // several times around a path of a radius of 1 mm
    [InlineData("engrave", "MARK", "")]
    [InlineData("engrave", "HOLES", "\"order\": \"level\",")]
    [InlineData("pocket", "CUT", "")]
    [InlineData("fill", "CUT", "\"spacing\": 4,")]
    public void A_ramp_descends_along_the_stroke(string kind, string layer, string fields)
    {
        var (previous, slope) = (new Dictionary<int, double>(), Math.Tan(5.0 * Math.PI / 180.0));
        var job = new OperationJob(OperationStrokesTests.Plate(), $$"""{ "id": "a", "kind": "{{kind}}", "select": {"layers": ["{{layer}}"]}, "tool": 1, "startDepth": 0.5, "depth": 3, "depthPerPass": 1.5, "finish": 0.2, "repeats": 2, {{fields}} "ramp": {"angle": 5} }""", diameter: layer == "HOLES" ? 0.5 : 2.0);

        Assert.Empty(job.CheckOf(job.Path));
        Assert.Equal(4, job.Passes.Strokes.Max(pass => pass.Pass) + 1);
        foreach (var (stroke, pass) in job.Path.Strokes.Zip(job.Passes.Strokes))
        {
            var ramp = stroke.Moves.Where(move => move.Role == StrokeRole.Ramp).ToList();
            var before = previous.GetValueOrDefault(pass.Stroke, 0.5);
            previous[pass.Stroke] = pass.Depth;
            Assert.All(stroke.Moves.Where(move => move.Role == StrokeRole.Cut), move => Assert.Equal((-pass.Depth, -pass.Depth), (move.StartZ, move.EndZ)));
            if (pass.Pass is 1 or 2) Assert.NotEqual(StrokeRole.Lead, stroke.Moves[0].Role); // a ramp in the slot has none
            if (pass.Pass == 3) Assert.Empty(ramp);
            if (pass.Pass == 3) continue;
            Assert.Equal((-before, -pass.Depth), (ramp[0].StartZ, ramp[^1].EndZ));
            Assert.Equal((pass.Depth - before) / slope, ramp.Sum(move => move.Segment.Length), 6);
            Assert.All(ramp, move => Assert.True(move.Segment.Kind == SegmentKind.Line && move.StartZ - move.EndZ <= (slope * move.Segment.Length) + 1e-9));
            Assert.True(ramp[^1].Segment.End.IsNear(stroke.Moves.First(move => move.Role == StrokeRole.Cut).Segment.Start, 1e-9));
        }
    }

    /// <summary>The tool descends on a circle that touches the start, by whole turns and never more steeply than stated, and is then at the depth of the
    /// pass.</summary>
    [Theory]
    [InlineData("profile", "CUT", "\"direction\": \"climb\", \"tabs\": {\"count\": 2, \"width\": 2, \"height\": 1}, \"leadIn\": {\"shape\": \"arc\", \"radius\": 2},")]
    [InlineData("profile", "CUT", "\"direction\": \"conventional\", \"side\": \"outside\",")]
    [InlineData("pocket", "CUT", "\"order\": \"level\",")]
    public void A_helix_descends_beside_the_start(string kind, string layer, string fields)
    {
        var slope = Math.Tan(5.0 * Math.PI / 180.0);
        var job = new OperationJob(OperationStrokesTests.Plate(), $$"""{ "id": "a", "kind": "{{kind}}", "select": {"layers": ["{{layer}}"]}, "tool": 1, "startDepth": 0.5, "depth": 3, "depthPerPass": 1.5, {{fields}} "ramp": {"angle": 5, "radius": 1.5} }""");
        var drawn = job.Assignment.Parts[0].Table.ToSegments();

        Assert.Empty(job.CheckOf(job.Path));
        // The small square has no room for one, which the finding says: its descents do not end where they begin.
        var turning = job.Path.Strokes.Where(stroke => stroke.Moves[0].Role == StrokeRole.Ramp && stroke.Moves.Last(move => move.Role == StrokeRole.Ramp).Segment.End.IsNear(stroke.Start, 1e-9)).ToList();
        Assert.True(turning.Count >= 2);
        foreach (var stroke in turning)
        {
            var helix = stroke.Moves.TakeWhile(move => move.Role == StrokeRole.Ramp).ToList();
            Assert.Equal(0.0, helix[0].Segment.Start.DistanceTo(helix[^1].Segment.End), 9);
            Assert.All(helix, move => Assert.True(move.StartZ - move.EndZ <= (slope * move.Segment.Length) + 1e-9));
            Assert.All(helix, move => Assert.True(drawn.Min(segment => segment.DistanceTo(move.Segment.PointAt(0.5))) >= 1.0 - 0.003));
            Assert.InRange(helix.Max(move => move.Segment.Start.DistanceTo(stroke.Start)), 0.75, 3.0 + 1e-9);
            Assert.Equal(helix[^1].EndZ, stroke.Moves[helix.Count].StartZ);
        }

        var steeper = job.Path with { Strokes = [.. job.Path.Strokes.Select(stroke => stroke.Index == turning[0].Index ? stroke with { Moves = [.. stroke.Moves.Skip(4)] } : stroke)] };
        Assert.Contains(job.CheckOf(steeper), finding => finding == "OPR0018");
    }

    [Fact]
    public void A_helix_without_room_becomes_a_ramp_and_is_named()
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 2.6).Build(), """{ "id": "a", "kind": "profile", "side": "inside", "select": "rest", "tool": 1, "depth": 1, "ramp": {"angle": 5, "radius": 3} }""");

        Assert.Equal(("OPR0055", "1"), (Assert.Single(job.Passes.Findings).Id, job.Passes.Findings[0].Facts[1]));
        Assert.Empty(job.CheckOf(job.Path));
        Assert.Equal(1.0 / Math.Tan(5.0 * Math.PI / 180.0), job.Path.Strokes[0].Moves.Where(move => move.Role == StrokeRole.Ramp).Sum(move => move.Segment.Length), 6);
    }

    [Fact]
    public void A_stroke_that_is_too_short_for_a_ramp_is_named()
    {
        var job = new OperationJob(new DrawingBuilder().Line(0, 0, 0.02, 0).Line(5, 0, 9, 0).Build(), """{ "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 3, "ramp": {"angle": 5} }""");

        Assert.Equal(("OPR0054", "1"), (Assert.Single(job.Passes.Findings).Id, job.Passes.Findings[0].Facts[1]));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Theory]
    [InlineData(45.0)]
    [InlineData(20.0)]
    public void Sloped_tabs_rise_along_the_contour(double angle)
    {
        var drawing = new DrawingBuilder().Square(0, 0, 60).Circle(120, 30, 30).Build();
        var job = new OperationJob(drawing, FormattableString.Invariant($$"""{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "depth": 3, "depthPerPass": 1.5, "tabs": {"count": 3, "width": 2, "height": 2, "shape": "sloped", "angle": {{angle}} } }"""));
        var slope = Math.Tan(angle * Math.PI / 180.0);

        Assert.Empty(job.CheckOf(job.Path));
        Assert.Empty(job.Passes.Findings);
        foreach (var (stroke, pass) in job.Path.Strokes.Zip(job.Passes.Strokes))
        {
            var tabs = stroke.Moves.Where(move => move.Role == StrokeRole.Tab).ToList();
            Assert.Equal([(4.0, -1.0), (4.0, -1.0), (4.0, -1.0)], tabs.Where(move => move.StartZ == move.EndZ).Select(move => (Math.Round(move.Segment.Length, 6), move.StartZ)));
            Assert.All(tabs.Where(move => move.StartZ != move.EndZ), move => Assert.Equal(slope, Math.Abs(move.EndZ - move.StartZ) / move.Segment.Length, 2));
            Assert.Equal(6.0 * (pass.Depth - 1.0), tabs.Sum(move => Math.Abs(move.EndZ - move.StartZ)), 6);
            Assert.All(stroke.Moves.Zip(stroke.Moves.Skip(1)), pair => Assert.True(pair.First.EndZ == pair.Second.StartZ && pair.First.Segment.End.IsNear(pair.Second.Segment.Start, 1e-9)));
        }
    }

    /// <summary>The tool is off over each tab, in every pass, and no stroke is shorter or longer for it.</summary>
    [Fact]
    public void A_tool_without_an_axis_leaves_gaps()
    {
        var job = new OperationJob(new DrawingBuilder().Square(0, 0, 40).Circle(80, 20, 15).Build(), """{ "id": "cut", "kind": "profile", "select": "rest", "tool": 1, "repeats": 2, "overcut": 1, "leadIn": {"shape": "arc", "radius": 2}, "leadOut": {"shape": "line", "length": 1}, "tabs": {"count": 3, "width": 2} }""", MachineProfile.Default);

        Assert.Empty(job.CheckOf(job.Path));
        Assert.Equal(2 * 2 * 4, job.Path.Strokes.Count);
        Assert.All(job.Path.Strokes, stroke => Assert.False(stroke.Closed));
        Assert.DoesNotContain(job.Path.Strokes.SelectMany(stroke => stroke.Moves), move => move.Role == StrokeRole.Tab);
        Assert.Equal(8, job.Path.Strokes.SelectMany(stroke => stroke.Moves).Count(move => move.Role == StrokeRole.Lead));
        foreach (var contour in job.Path.Strokes.Zip(job.Passes.Strokes).GroupBy(stroke => (stroke.Second.Stroke, stroke.Second.Pass), stroke => stroke.First))
        {
            var pieces = contour.ToList();
            var gaps = pieces.Zip(pieces.Skip(1)).Select(pair => pair.First.End.DistanceTo(pair.Second.Start)).ToList();
            Assert.All(gaps, gap => Assert.Equal(4.0, gap, 1));
            Assert.Equal(12.0, (pieces.Any(piece => piece.Start.X < 45.0) ? (4 * 40.0) + (2.0 * Math.PI) : 32.0 * Math.PI) + 2.0 + Math.PI - pieces.Sum(piece => piece.Length), 6);
        }

        Assert.Equal(6, job.Passes.Places[0].Tabs.Count);
        Assert.NotEmpty(job.CheckOf(job.Path with { Strokes = [.. job.Path.Strokes.Select((stroke, index) => index == 1 ? stroke with { Moves = [.. stroke.Moves.Skip(1)] } : stroke)] }));
    }

    private static Layer Visible(string name) => new(name, On: true, Frozen: false, Plot: true);

    /// <summary>Shapes at random places with holes in them, some near others. What is checked uses the drawn segments only.</summary>
    [Fact]
    public void No_lead_enters_a_part_tabs_are_left_and_the_wall_is_on_the_right()
    {
        for (var seed = 0; seed < TestExtent.Cases(40, 2000, "ENGRAVER_OPERATION_SHAPES"); seed++)
        {
            var drawing = Shapes(new Random(seed));
            var job = new OperationJob(drawing, s_variants[seed % s_variants.Length]);
            var drawn = job.Assignment.Parts[0].Table.ToSegments();
            Assert.True(job.Shapes[0].Faults.Count == 0, $"{seed}: {string.Join(' ', job.Shapes[0].Faults.Select(fault => fault.Sentence))}");
            Assert.Empty(job.CheckOf(job.Path));
            foreach (var stroke in job.Path.Strokes)
            {
                Assert.All(OperationJob.PointsOf(stroke, 0.05), place => Assert.True(drawn.Min(segment => segment.DistanceTo(place)) >= Radius - 0.002, $"{seed}: {place}"));
                Assert.All(stroke.Moves.Where(move => move.Role == StrokeRole.Ramp), move => Assert.True(move.StartZ - move.EndZ <= (s_rampSlope * move.Segment.Length) + 1e-9, $"{seed}"));
                var contour = stroke with { Moves = [.. stroke.Moves.Where(move => move.Role is not (StrokeRole.Lead or StrokeRole.Ramp))] };
                var area = OperationJob.AreaOf([.. OperationJob.PointsOf(contour, 0.1)]);
                var isOutside = Math.Abs(area) > 200.0; // the smallest part has 314 mm2, the largest hole 95
                Assert.Equal(isOutside, area < 0.0);
                var up = stroke.Moves.Where(move => move.Role == StrokeRole.Tab && move.StartZ == move.EndZ).ToList();
                Assert.All(up, move => Assert.Equal((4.0, -2.0), (Math.Round(move.Segment.Length, 6), move.StartZ)));
                Assert.InRange(up.Count, 0, 3);
                if (isOutside && stroke.Moves[^1].EndZ == -3.0) Assert.True(up.Count >= 2, $"{seed}: {up.Count} tabs");
            }

            // No pass of a contour cuts into its tabs: 2 mm wide, and the radius of the tool on both sides.
            foreach (var contour in job.Path.Strokes.Zip(job.Passes.Strokes).GroupBy(stroke => stroke.Second.Stroke, stroke => stroke.First))
            {
                var moves = contour.SelectMany(stroke => stroke.Moves).ToList();
                var deep = moves.Where(move => Math.Min(move.StartZ, move.EndZ) < -2.0 - 1e-6).Select(move => move.StartZ == move.EndZ ? move.Segment : SegmentBelow(move)).ToList();
                Assert.All(moves.Where(move => move.Role == StrokeRole.Tab && move.StartZ == move.EndZ), tab => Assert.True(deep.Min(segment => segment.DistanceTo(tab.Segment.PointAt(0.5))) > 1.98, $"{seed}: {tab.Segment.Start}"));
            }
        }
    }

    /// <summary>The part of a slope that is below the tabs.</summary>
    private static Segment SegmentBelow(StrokeMove slope)
    {
        var part = (-2.0 - slope.StartZ) / (slope.EndZ - slope.StartZ);
        if (part is not (> 0.0 and < 1.0)) return slope.Segment;
        return slope.StartZ > slope.EndZ ? Segment.FromLine(slope.Segment.PointAt(part), slope.Segment.End) : Segment.FromLine(slope.Segment.Start, slope.Segment.PointAt(part));
    }

    /// <summary>Squares, rounded squares and circles of 20 to 30 mm in a grid with gaps of 3 mm or more, each with a round hole or none.</summary>
    private static Drawing Shapes(Random random)
    {
        var builder = new DrawingBuilder();
        for (var column = 0; column < 3; column++)
        {
            for (var row = 0; row < 2; row++)
            {
                var size = 20.0 + (10.0 * random.NextDouble());
                var (x, y) = ((column * 33.0) + random.NextDouble(), (row * 33.0) + random.NextDouble());
                _ = random.Next(3) switch
                {
                    0 => builder.Square(x, y, size),
                    1 => builder.Circle(x + (size / 2.0), y + (size / 2.0), size / 2.0),
                    _ => builder.Curve(CurveType.LwPolyline, Rounded(x, y, size, 1.0 + (3.0 * random.NextDouble()))),
                };
                if (random.Next(2) == 0) builder.Circle(x + (size / 2.0), y + (size / 2.0), 1.5 + (4.0 * random.NextDouble()));
            }
        }

        return builder.Build();
    }

    private static Segment[] Rounded(double x, double y, double size, double r) =>
    [
        Line(x + r, y, x + size - r, y), Corner(x + size - r, y + r, r, 270), Line(x + size, y + r, x + size, y + size - r), Corner(x + size - r, y + size - r, r, 0),
        Line(x + size - r, y + size, x + r, y + size), Corner(x + r, y + size - r, r, 90), Line(x, y + size - r, x, y + r), Corner(x + r, y + r, r, 180),
    ];

    private static Segment Corner(double x, double y, double r, double from) => Segment.FromArc(new ArcSegment(new Point2D(x, y), r, Angle.FromDegrees(from), Angle.FromDegrees(90.0)));

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static double ToSquare(Point2D place, double x, double y, double side) => double.Hypot(Math.Max(Math.Max(x - place.X, place.X - x - side), 0.0), Math.Max(Math.Max(y - place.Y, place.Y - y - side), 0.0));
}
