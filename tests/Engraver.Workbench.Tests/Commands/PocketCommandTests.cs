using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Sequencing.Ordering;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

public class PocketCommandTests
{
    /// <summary>A circle of radius 3 and a tool of 2, half a diameter from pass to pass: passes of radius 2, 1 and a last one that is a point.</summary>
    [Fact]
    public async Task A_circle_is_cleared_on_a_layer_of_its_own_and_undone()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State.Drawing!;
        await talk.TypeAsync("POCKET", "H", "A3", "", "2", "0.5", "Contour", "0");
        var drawing = talk.State.Drawing!;
        var added = talk.State.Previous.Single();

        Assert.Equal("POCKET", drawing.Layers[drawing.Entities[added].Layer].Name);
        Assert.Equal(CurveType.LwPolyline, drawing.Entities[added].Type);
        Assert.Contains("100 % of 28.274 mm2 covered", talk.Said, StringComparison.Ordinal);
        Assert.Equal(["POCKET"], talk.State.Settings.Layers!); // The circle itself would be cut half a tool diameter into the wall.
        Assert.DoesNotContain("half a tool diameter into the wall", talk.Said, StringComparison.Ordinal);
        Assert.All(Outline(drawing, added), segment => Assert.True(segment.PointAt(0.5).DistanceTo(new Point2D(20, 5)) <= 2.0 + 1e-9));
        await talk.TypeAsync("U");
        Assert.Same(before, talk.State.Drawing);
    }

    [Fact]
    public async Task Values_are_remembered_and_levels_lie_at_their_depths()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A4", "", "1", "0.7", "Zigzag", "30", "2", "1");
        Assert.Equal([-1.0, -2.0], talk.State.Previous.Select(index => talk.State.Drawing!.Parts[talk.State.Drawing.Entities[index].FirstPart].C));
        await talk.TypeAsync("U", "POCKET", "H", "A4", "", "", "", "", "", "", "");
        Assert.Equal([-1.0, -2.0], talk.State.Previous.Select(index => talk.State.Drawing!.Parts[talk.State.Drawing.Entities[index].FirstPart].C));
        Assert.Contains("POC0002", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_the_tool_does_not_fit_into_is_said_and_changes_nothing()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State.Drawing;

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("POCKET", "H", "A3", "", "7", "0.5", "Contour", "0"));
        Assert.Contains("POC0001", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("POCKET", "H", "A1", "", "1", "0.5", "Contour", "0"));
        Assert.Contains("POC0005", talk.Said, StringComparison.Ordinal);
        Assert.Same(before, talk.State.Drawing);
    }

    /// <summary>Each prompt previews the result of Enter; at the depth prompt this is the final result.</summary>
    [Fact]
    public async Task The_passes_are_seen_before_they_are_taken()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A3", "");
        Assert.Equal(2.5, Widest(talk), 9); // The default tool of 1.
        await talk.TypeAsync("2");
        Assert.Equal(2.0, Widest(talk), 9);
        await talk.TypeAsync("0.5", "Contour", "Allowance");
        Assert.Contains("allowance on the walls", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("0.25", "From", "Centre");
        var shown = talk.Session.Prompt.Preview!(default).ToList();
        await talk.TypeAsync("0");
        var drawn = talk.State.Previous.SelectMany(index => Outline(talk.State.Drawing!, index)).ToList();

        Assert.Equal(drawn.Sum(segment => segment.Length), shown.Sum(segment => segment.Length), 9);
        Assert.All(drawn, segment => Assert.Contains(shown, one => one.DistanceTo(segment.PointAt(0.5)) < 1e-9));
        Assert.Null(talk.Session.Prompt.Preview);
        Assert.InRange(drawn[^1].Start.DistanceTo(new Point2D(20, 5)), 2.0 - 1e-9, 2.0 + 1e-9); // The last pass is along the wall.
    }

    /// <summary>Passes of radius 2 and 1, inwards or outwards.</summary>
    [Theory]
    [InlineData("Wall", 2.0, 1.0)]
    [InlineData("Centre", 1.0, 2.0)]
    public async Task It_is_cleared_from_the_wall_or_from_the_centre(string from, double first, double last)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A3", "", "2", "0.5", "Contour", "From", from, "0");
        var drawn = Outline(talk.State.Drawing!, talk.State.Previous.Single());

        Assert.Equal(first, drawn[0].Start.DistanceTo(new Point2D(20, 5)), 3);
        Assert.Equal(last, drawn[^1].End.DistanceTo(new Point2D(20, 5)), 3);
    }

    [Fact]
    public async Task In_a_drawing_in_inches_the_passes_are_shown_where_they_will_be()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Circle(1, 1, 1).Build() with { Unit = LengthUnits.FromInsUnits(1)! } });
        await talk.TypeAsync("POCKET", "ALL", "", "12.7", "");
        Assert.Equal(0.75, talk.Session.Prompt.Preview!(default).Max(segment => segment.Start.DistanceTo(new Point2D(1, 1))), 9);
    }

    /// <summary>Ramps precede their strokes; nothing else is cut, and one undo step reverts everything.</summary>
    [Fact]
    public async Task A_pocket_with_ramps_becomes_the_job_and_is_cut_by_a_mill()
    {
        await using var talk = CommandTestSession.WithDrawing();
        talk.Session.Document.Commit("CNCPROFILE", talk.State with { Settings = talk.State.Settings with { Machine = MachineProfileSource.Load(CommandTestSession.Sample("machine-mill.json")), Kerf = KerfSide.Nesting, ToolDiameterMm = 2.0 } });
        var before = talk.State;
        await talk.TypeAsync("POCKET", "H", "A4", "", "2", "0.5", "Contour", "Entry", "Ramp", "5", "Job", "Pocket", "1", "0.5");
        var (drawing, settings) = (talk.State.Drawing!, talk.State.Settings);
        var heights = talk.State.Previous.Select(index => drawing.Parts[drawing.Entities[index].FirstPart]).Select(part => (part.C, part.Kind == SegmentKind.Line ? part.F : part.C)).ToList();

        Assert.Equal(["POCKET"], settings.Layers!);
        Assert.Equal((StrokeOrder.Drawn, KerfSide.Off), (settings.Order, settings.Kerf));
        Assert.Equal((0.0, true), (heights[0].C, heights[0].Item2 < 0.0)); // An entry move first.
        Assert.Contains((-0.5, -0.5), heights);
        Assert.Equal((-1.0, -1.0), heights[^1]);
        Assert.Contains("The job cuts only layer POCKET", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("half a tool diameter", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM"));
        var judged = talk.Session.Machine.Runs.LastRun!.Judgement;
        Assert.InRange(judged.MaxDeviationMm!.Value, 0.0, 0.01);
        Assert.Equal(0.0, judged.MissingLengthMm);
        await talk.TypeAsync("U");
        Assert.Same(before.Drawing, talk.State.Drawing);
        Assert.Equal(before.Settings, talk.State.Settings);
    }

    [Fact]
    public async Task The_job_may_stay_the_whole_drawing_and_that_choice_is_not_taken_over()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A4", "", "2", "0.5", "Contour", "Job");
        Assert.Contains("Everything also cuts the outlines, half a tool diameter into the wall", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.EndsWith("<Pocket>:", talk.Session.Prompt.Text.TrimEnd(), StringComparison.Ordinal);
        await talk.TypeAsync("Everything", "0");
        Assert.Null(talk.State.Settings.Layers);
        Assert.Contains("The outlines stay in the drawing", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U", "POCKET", "H", "A4", "", "", "", "", "");

        Assert.Equal(["POCKET"], talk.State.Settings.Layers!);
    }

    /// <summary>With all defaults nothing is cut closer to the wall than the tool radius.</summary>
    [Fact]
    public async Task What_Enter_gives_never_cuts_into_the_wall()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A3", "", "2", "0.5", "", "0", "CNCCONNECT", "sim:");
        var derived = await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);
        var moves = derived.Job!.Toolpath.Strokes.SelectMany(stroke => stroke.Moves).ToList();

        Assert.NotEmpty(moves);
        Assert.All(moves, move => Assert.InRange(move.Segment.PointAt(0.5).DistanceTo(new Point2D(20, 5)), 0.0, 3.0 - 1.0 + 0.001));
    }

    /// <summary>A square of 8: a tool of 7.8 has no room for a helix and plunges along its pass; for one of 8 the pocket is a single position.</summary>
    [Theory]
    [InlineData("7.8", "POC0007", 1)]
    [InlineData("8", "POC0008", 0)]
    public async Task A_way_down_without_room_is_told(string diameter, string id, int ways)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A4", "", diameter, "0.5", "Contour", "Entry", "Helix", "3", "1", "1");

        Assert.Contains(id, talk.Said, StringComparison.Ordinal);
        Assert.Equal(1 + ways, talk.State.Previous.Count);
    }

    private static double Widest(CommandTestSession talk) => talk.Session.Prompt.Preview!(default).Max(segment => segment.Start.DistanceTo(new Point2D(20, 5)));

    private static List<Segment> Outline(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        return [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
    }
}
