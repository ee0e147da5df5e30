using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

public class CommandGrammarTests
{
    [Fact]
    public async Task A_command_is_found_by_name_alias_and_prefixed_name_in_any_case()
    {
        foreach (var typed in new[] { "MOVE", "m", "_move", ".Move", "'id", "-LAYER" })
        {
            await using var talk = CommandTestSession.WithDrawing();

            Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync(typed));
        }
    }

    [Fact]
    public async Task The_prompt_says_what_is_asked_with_options_and_default()
    {
        await using var talk = CommandTestSession.WithDrawing();
        Assert.Equal("Command:", talk.Session.Prompt.Text);
        await talk.TypeAsync("ROTATE", "ALL", "", "0,0");
        var prompt = talk.Session.Prompt;

        Assert.Equal(("ROTATE", "Specify rotation angle or [Copy/Reference] <0>:"), (prompt.Command, prompt.Text));
        Assert.Equal(["Copy", "Reference"], prompt.Options.Select(option => option.Name));
        Assert.Equal(new PointRequest(PointPurpose.Place, new Point2D(0, 0)), prompt.PointRequest! with { Ghost = null });
    }

    /// <summary>A key of the desktop can still start a nested command.</summary>
    [Fact]
    public async Task In_an_answer_of_text_an_apostrophe_is_a_letter()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("'id"), new DxfText().Header("AC1015", 4).Section("ENTITIES", [(0, "LINE"), (8, "'ZOOM"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0)]).End().ToAscii());
        await talk.TypeAsync("OPEN", "'id");
        Assert.Equal(1, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("LAYER", "Freeze", "'ZOOM", "");
        Assert.Contains(talk.State.Drawing!.Layers, layer => layer is { Name: "'ZOOM", Frozen: true });
        await talk.TypeAsync("SAVEAS");
        await talk.Session.EnterNestedAsync("ID", CancellationToken.None);
        Assert.Equal(">>Specify point:", talk.Session.Prompt.Text);
        await talk.TypeAsync("1,2");
        Assert.Equal("SAVEAS", talk.Session.Prompt.Command);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("'DIST"));
        Assert.True(File.Exists(talk.PathOf("'DIST.dxf")));
    }

    [Fact]
    public async Task The_default_is_the_value_that_was_used_last()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("RO", "ALL", "", "0,0", "45");
        await talk.TypeAsync("RO", "P", "", "0,0");

        Assert.Equal("45", talk.Session.Prompt.Default);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
    }

    [Fact]
    public async Task Enter_repeats_the_last_command_but_never_one_that_starts_motion()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ID", "1,2", "");
        Assert.Equal("ID", talk.Session.Prompt.Command);
        await talk.TypeAsync("3,4", "CNCCONNECT", "sim:", "CNCRUN", "No");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.Contains("CNCRUN starts motion and is not repeated with Enter", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Machine.Runs.LastRun);
    }

    [Fact]
    public async Task A_transparent_command_asks_in_between_and_the_outer_one_goes_on()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "'DIST");
        Assert.Equal(">>Specify first point:", talk.Session.Prompt.Text);
        await talk.TypeAsync("0,0", "3,4");
        Assert.Contains("Distance = 5", talk.Said, StringComparison.Ordinal);
        Assert.Equal("MOVE", talk.Session.Prompt.Command);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("#1,1"));
        Assert.Equal(new Point2D(1, 1), talk.State.Drawing!.Parts[0].InPlan().Start);
    }

    [Fact]
    public async Task A_command_that_changes_something_cannot_be_transparent()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var result = await talk.TypeAsync("MOVE", "'ERASE");

        Assert.IsType<InputResult.NotAccepted>(result);
        Assert.Equal("MOVE", talk.Session.Prompt.Command);
    }

    [Fact]
    public async Task What_is_not_understood_leaves_command_and_prompt_as_they_were()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MOVE", "ALL", "");
        var before = talk.Session.Prompt;

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("somewhere"));
        Assert.Equal(before.Text, talk.Session.Prompt.Text);
        Assert.IsType<InputResult.NotAccepted>(await new CommandTestSession().TypeAsync("FLY"));
    }

    [Fact]
    public async Task Esc_ends_every_command_clears_the_selection_and_changes_nothing()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SELECT", "ALL", "");
        Assert.Equal(4, talk.State.Selection.Count);
        var drawing = talk.State.Drawing;
        await talk.TypeAsync("MOVE", "0,0", "'ID");
        await talk.Session.CancelAsync();

        Assert.Equal(PromptView.Idle, talk.Session.Prompt);
        Assert.Same(drawing, talk.State.Drawing);
        Assert.Empty(talk.State.Selection);
    }

    [Fact]
    public async Task Suggestions_show_the_alias_first_and_CNC_lists_the_machine()
    {
        await using var talk = new CommandTestSession();

        Assert.Equal("M (MOVE)", talk.Session.Suggest("m")[0].Text);
        Assert.Contains("MOVE", talk.Session.Suggest("mo").Select(found => found.Text));
        Assert.Superset(new HashSet<string> { "CNCRUN", "CNCSTOP", "CNCCONNECT" }, talk.Session.Suggest("CNC").Select(found => found.Text).ToHashSet());
        Assert.Empty(talk.Session.Suggest("zzz"));
    }

    [Fact]
    public async Task The_operators_alias_file_wins_and_cannot_shorten_what_starts_motion()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("my.pgp"), "M, *MIRROR\nGO, *CNCRUN\nRUN, *CNCRUN\n");
        await talk.TypeAsync("REINIT", "M");

        Assert.Equal("MIRROR", talk.Session.Prompt.Command);
        Assert.Contains("GO is too short for CNCRUN", talk.Said, StringComparison.Ordinal);
        Assert.Equal(("CNCRUN", null), (talk.Session.Aliases.CommandOf("RUN"), talk.Session.Aliases.CommandOf("GO")));
    }

    [Fact]
    public async Task Every_built_in_alias_stands_for_a_command_that_is_built()
    {
        await using var talk = new CommandTestSession();

        Assert.All(talk.Session.Aliases.Commands.Values, name => Assert.NotNull(talk.Session.Catalog.Find(name)));
        Assert.Empty(talk.Session.Aliases.Findings);
    }

    [Fact]
    public async Task The_journal_is_a_script_that_does_the_same_again()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "SC", "ALL", "", "0,0", "2.5", "MI", "L", "", "0,0", "0,1", "");
        await using var again = new CommandTestSession();
        await File.WriteAllTextAsync(again.PathOf("journal.scr"), talk.Journal.ToString());
        await again.TypeAsync("SCRIPT", "journal.scr");

        Assert.Equal(Fingerprint.Of(talk.State), Fingerprint.Of(again.State));
        Assert.Equal(5, again.State.Drawing!.Entities.Count);
    }
}
