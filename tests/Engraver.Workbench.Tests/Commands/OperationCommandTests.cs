using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>OPERATION on the plate of the samples.</summary>
public class OperationCommandTests
{
    [Fact]
    public async Task A_file_is_loaded_shown_undone_and_saved_as_it_was()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "LO", CommandTestSession.Sample("operation-plate.operations.json"));
        var plan = Plan(talk)!;
        Assert.Equal(["marks", "holes", "pocket", "outline"], plan.Operations.Select(operation => operation.Id));
        await talk.TypeAsync("OPERATION", "SH");
        Assert.Contains("4. outline \"Outline\": Profile with tool End mill 3 (3), depth 3 mm, 500 mm/min", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("OPERATION", "Save", talk.PathOf("again.json"), "U");
        Assert.Null(Plan(talk));
        await talk.TypeAsync("OPERATION", "LO", talk.PathOf("again.json"));
        Assert.Equal(plan, Plan(talk));
        await talk.TypeAsync("OPERATION", "New", "E", "0", "1", "0.1"); // a tool of the library that no operation has used
        Assert.Equal(("Engraver 60", 0.2), (Plan(talk)!.ToolOf(Plan(talk)!.Operations[4]).Name, Plan(talk)!.Tools[0].Diameter));
        await talk.TypeAsync("U");
        var job = JobPreparation.Prepare(talk.State.Drawing!, talk.State.Settings, MotionStyle.Continuous);
        Assert.Empty(job.Faults);
        Assert.NotNull(job.Motion.Program);
    }

    [Fact]
    public async Task Operations_are_added_edited_switched_moved_and_deleted()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "New", "R", "CUT", "3", "2.5", "4");
        await talk.TypeAsync("OPERATION", "New", "E", "*", "3", "0.2");
        Assert.Equal(["o1 Profile CUT 3 4", "o2 Engrave  3 0.2"], Plan(talk)!.Operations.Select(one => FormattableString.Invariant($"{one.Id} {one.Kind} {string.Join(',', one.Select.Layers)} {one.Tool} {one.Depth}")));
        Assert.Equal((2.5, true), (Plan(talk)!.Tools[0].Diameter, Plan(talk)!.Operations[1].Select.IsRest));

        await talk.TypeAsync("OPERATION", "Edit", "o1", "direction", "climb");
        await talk.TypeAsync("OPERATION", "Edit", "o1", "name", "Outline");
        await talk.TypeAsync("OPERATION", "Edit", "outline", "depthPerPass", "1.5");
        await talk.TypeAsync("OPERATION", "SW", "o2");
        await talk.TypeAsync("OPERATION", "Move", "o2", "1");
        Assert.Equal([("o2", false, null), ("o1", true, (double?)1.5)], Plan(talk)!.Operations.Select(one => (one.Id, one.IsOn, one.DepthPerPass)));
        Assert.Equal(CutDirection.Climb, Plan(talk)!.Operations[1].Direction);

        await talk.TypeAsync("OPERATION", "Edit", "o1", "depthPerPass", "");
        Assert.Null(Plan(talk)!.Operations[1].DepthPerPass);
        await talk.TypeAsync("OPERATION", "Tool", "3");
        Assert.Equal(3, talk.State.Settings.Tool);
        await talk.TypeAsync("OPERATION", "Delete", "o2", "OPERATION", "Delete", "o1");
        Assert.Equal((null, 0), (Plan(talk), talk.State.Settings.Tool));
    }

    [Theory]
    [InlineData("depth", "-1", "Allowed: a number above 0")]
    [InlineData("dept", "1", "The field operations[0].dept is unknown")]
    [InlineData("kind", "mill", "Allowed: engrave, profile, pocket, fill, drill")]
    [InlineData("tool", "9", "Allowed: 3")]
    public async Task An_edit_that_is_not_valid_changes_nothing_and_says_why(string field, string value, string message)
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "New", "E", "*", "3", "2.5", "1");
        var before = Plan(talk);
        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OPERATION", "Edit", "o1", field, value));

        Assert.Contains(message, failed.Message, StringComparison.Ordinal);
        Assert.Equal(before, Plan(talk));
    }

    [Fact]
    public async Task Kerf_and_an_entering_place_are_refused_beside_operations_and_another_drawing_has_none()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "LO", CommandTestSession.Sample("operation-plate.operations.json"));

        Assert.Contains("cannot be used with OPERATION", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("KERF", "N", "3")).Message, StringComparison.Ordinal);
        Assert.Contains("cannot be used with OPERATION", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("ENTER", "P", "0,0")).Message, StringComparison.Ordinal);
        await talk.TypeAsync("OPERATION", "R", "KERF", "N", "3");
        Assert.Contains("KERF cannot be used", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OPERATION", "LO", CommandTestSession.Sample("operation-plate.operations.json"))).Message, StringComparison.Ordinal);
        await talk.TypeAsync("KERF", "OFF", "OPERATION", "LO", CommandTestSession.Sample("operation-plate.operations.json"), "OPEN", CommandTestSession.Sample("paper-001.dxf"));
        Assert.Null(Plan(talk));
    }

    [Fact]
    public async Task Operations_are_saved_beside_the_drawing_and_opened_with_it_with_the_handles_of_the_new_file()
    {
        await using var talk = await PlateAsync();
        var handle = talk.Session.Document.Current.Drawing!.SourceOf(0).Handle!;
        await talk.TypeAsync("OPERATION", "New", "E", "*", "3", "2.5", "1", "OPERATION", "Edit", "o1", "select", $$"""{"handles": ["{{handle}}"]}""");
        var file = talk.PathOf("plate.dxf");
        await talk.TypeAsync("SAVEAS", file);
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("OPERATION", "Edit", "o1", "depth", "0.5");
        Assert.True(talk.Session.Document.IsEdited);
        await talk.TypeAsync("QSAVE", "CLOSE");
        Assert.Null(Plan(talk));

        await talk.TypeAsync("OPEN", file);
        var operation = Assert.Single(Plan(talk)!.Operations);
        Assert.Equal(0.5, operation.Depth);
        Assert.Equal(0, talk.State.Drawing!.IndexOfHandle(Assert.Single(operation.Select.Handles)));
        Assert.Contains("Operations: 1", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Operations_of_a_later_version_are_kept_and_not_run()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "New", "E", "*", "3", "2.5", "1");
        var file = talk.PathOf("plate.dxf");
        await talk.TypeAsync("SAVEAS", file, "CLOSE");
        var beside = file + ".engraver.json";
        await File.WriteAllTextAsync(beside, (await File.ReadAllTextAsync(beside)).Replace("\"depth\":1", "\"depth\":1,\"wobble\":3", StringComparison.Ordinal));

        await talk.TypeAsync("OPEN", file);
        Assert.Null(Plan(talk));
        Assert.Contains("SID0006", talk.Said, StringComparison.Ordinal);
        Assert.Contains("wobble", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("LINE", "0,0", "1,1", "", "QSAVE", "Yes");
        Assert.Contains("\"wobble\":3", await File.ReadAllTextAsync(beside), StringComparison.Ordinal);
        await talk.TypeAsync("OPERATION", "LO", CommandTestSession.Sample("operation-plate.operations.json"), "QSAVE");
        Assert.True(!(await File.ReadAllTextAsync(beside)).Contains("wobble", StringComparison.Ordinal), talk.Said);
    }

    /// <summary>The outline of the plate is a rectangle from 0, 0 to 90, 60.</summary>
    [Fact]
    public async Task Starts_are_picked_replaced_and_undone()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "New", "R", "CUT", "3", "3", "4");
        await talk.TypeAsync("OPERATION", "STart", "o1", "20,0", "200,200", "40,61", "");
        Assert.Contains("No closed contour of the operation is near this place.", talk.Said, StringComparison.Ordinal);
        Assert.Equal([new Point2D(40.0, 61.0)], Plan(talk)!.Operations[0].StartAt); // the new start replaces the first one
        var outline = JobPreparation.Prepare(talk.State.Drawing!, talk.State.Settings, MotionStyle.Continuous).Toolpath.Strokes[^1];
        Assert.Equal((40.0, 61.5), (Math.Round(outline.Start.X, 6), Math.Round(outline.Start.Y, 6)));
        await talk.TypeAsync("OPERATION", "STart", "o1", "68,22", "", "U");
        Assert.Single(Plan(talk)!.Operations[0].StartAt);
        await talk.TypeAsync("OPERATION", "STart", "o1", "C", "");
        Assert.Empty(Plan(talk)!.Operations[0].StartAt);
        await talk.TypeAsync("OPERATION", "New", "E", "*", "3", "0.2", "OPERATION", "STart", "o2");
        Assert.Contains("Operation o2 is not a profile", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Tabs_are_added_moved_removed_and_undone()
    {
        await using var talk = await PlateAsync();
        await talk.TypeAsync("OPERATION", "New", "R", "CUT", "3", "3", "4");
        await talk.TypeAsync("OPERATION", "TAbs", "o1", "20,0", "3", "1", "200,200", "60,60", "");
        Assert.Contains("There is no room for a tab near this place.", talk.Said, StringComparison.Ordinal);
        Assert.Equal(["20 -1.5", "60 61.5"], Tabs(talk));
        await talk.TypeAsync("OPERATION", "TAbs", "o1", "Move", "62,55", "70,60", "Remove", "20,0", "");
        Assert.Equal(["70 61.5"], Tabs(talk));
        await talk.TypeAsync("U");
        Assert.Equal(["20 -1.5", "60 61.5"], Tabs(talk));

        // Tabs by number remain where they are when one of them is removed.
        await talk.TypeAsync("OPERATION", "Edit", "o1", "tabs", """{"count": 4, "width": 3, "height": 1}""");
        var before = JobPreparation.To<Engraver.Workbench.Stages.OrderedJob>(talk.State.Drawing!, talk.State.Settings).Places[0].Tabs;
        await talk.TypeAsync("OPERATION", "TAbs", "o1", "Remove", FormattableString.Invariant($"{before[0].X},{before[0].Y}"), "");
        Assert.Equal(before.Skip(1), JobPreparation.To<Engraver.Workbench.Stages.OrderedJob>(talk.State.Drawing!, talk.State.Settings).Places[0].Tabs);
        Assert.Null(Plan(talk)!.Operations[0].Tabs!.Count);
    }

    private static IEnumerable<string> Tabs(CommandTestSession talk) => Plan(talk)!.Operations[0].Tabs!.At.Select(place => FormattableString.Invariant($"{Math.Round(place.X, 6)} {Math.Round(place.Y, 6)}")).Order(StringComparer.Ordinal);

    private static OperationPlan? Plan(CommandTestSession talk) => talk.State.Settings.Operations;

    /// <summary>The height of the work is set with the second tool, 4 mm higher; setting it keeps what START cuts.</summary>
    [Fact]
    public async Task A_job_of_two_tools_ends_at_the_change_and_its_rest_is_cut_at_the_new_height()
    {
        await using var talk = await PlateAsync();
        await File.WriteAllTextAsync(talk.PathOf("two.json"), """
            { "version": "1.0", "tools": [{"number": 1, "diameter": 0.2}, {"number": 3, "name": "Drill", "diameter": 3}],
              "operations": [
                { "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.2 },
                { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
            """);
        await talk.TypeAsync("OPERATION", "LO", talk.PathOf("two.json"), "CNCCONNECT", "sim:", "CNCZERO", "All");
        var runs = talk.Session.Machine.Runs;

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Contains("the rest needs tool Drill (3)", talk.Said, StringComparison.Ordinal);
        Assert.Equal((JobOutcome.ToolChange, true), (runs.LastRun!.Result.Outcome, runs.Part is { Break.IsToolChange: true }));
        await talk.TypeAsync("CNCZERO", "Z", "Yes");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Equal((JobOutcome.Complete, null), (runs.LastRun!.Result.Outcome, runs.Part));
        Assert.Equal(4.0, runs.LastRun.Placement!.Frame!.Value.Z / 800.0, 6);
        Assert.Equal(["b"], runs.LastRun.Judgement.Operations.Select(one => one.Id));

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM"));
        Assert.Equal((JobOutcome.Complete, 2), (runs.LastRun!.Result.Outcome, runs.LastRun.Sections.Count));
    }

    /// <summary>Marks with a stop before their repeat, then holes with another tool, each continued by CNCCONTINUE: it asks, also about a height that was not
    /// set with the next tool.</summary>
    [Fact]
    public async Task A_job_is_continued_behind_a_stop_and_a_change_of_the_tool()
    {
        await using var talk = await PlateAsync();
        await File.WriteAllTextAsync(talk.PathOf("two.json"), """
            { "version": "1.0", "tools": [{"number": 1, "diameter": 0.2}, {"number": 3, "name": "Drill", "diameter": 3}],
              "operations": [
                { "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.2, "repeats": 2, "stopBetween": true },
                { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
            """);
        await talk.TypeAsync("OPERATION", "LO", talk.PathOf("two.json"), "CNCCONNECT", "sim:", "CNCZERO", "All");
        var runs = talk.Session.Machine.Runs;
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONTINUE"));

        await talk.TypeAsync("CNCRUN", "Yes");
        Assert.Contains("Next: Repeat 2 of 2 of a", talk.Said, StringComparison.Ordinal);
        Assert.Equal((JobOutcome.OperatorStop, false), (runs.LastRun!.Result.Outcome, runs.Part!.Break!.NeedsHeight(talk.Session.Machine.Profile)));
        var first = runs.LastRun;
        await talk.TypeAsync("CNCCONTINUE", "No");
        await talk.TypeAsync("CNCCONTINUE", "");
        Assert.Same(first, runs.LastRun);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCCONTINUE", "Yes"));
        Assert.Equal((JobOutcome.ToolChange, 2, first.Journal), (runs.LastRun!.Result.Outcome, runs.LastRun.Section!.Tool.Repeat, runs.LastRun.ResumedFrom is null ? null : first.Journal));

        var second = runs.LastRun;
        await talk.TypeAsync("CNCCONTINUE", "Yes");
        Assert.Contains("was not set with tool Drill (3)", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("No");
        Assert.Same(second, runs.LastRun);
        await talk.TypeAsync("CNCGOTO", "5,0", "CNCZERO", "All", "Yes");
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONTINUE", "Yes"));
        Assert.Contains("JOB0040", talk.Said, StringComparison.Ordinal);
        Assert.NotNull(runs.Part?.Break);
    }

    private static async Task<CommandTestSession> PlateAsync()
    {
        var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("operation-plate.dxf"), "CNCPROFILE", CommandTestSession.Sample("machine-mill.json"));
        return talk;
    }
}
