using Engraver.Workbench.Commands;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands.Files;

public class VerifyCommandTests
{
    [Theory]
    [InlineData("Galil")]
    [InlineData("galil-Calls")]
    public async Task A_script_posts_the_open_drawing_and_verifies_what_it_wrote(string target)
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("job.scr"), $"OPEN \"{CommandTestSession.Sample("gasket.dxf")}\"\nTOOLSTART 5,7\nPOST {target} job.dmc\nVERIFY job.dmc\n");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SCRIPT", "job.scr"));
        Assert.Matches(@"\nok: maximum deviation 0\.00[0-3]\d mm \(0\.0035 mm allowed\), 0 mm missing, 0 mm not in the drawing\.$", talk.Said);
    }

    [Fact]
    public async Task What_was_posted_last_is_offered_and_an_edit_after_the_post_is_found()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "POST", "Galil", "job.dmc", "VERIFY");
        Assert.Equal(("VERIFY", "job.dmc"), (talk.Session.Prompt.Command, talk.Session.Prompt.Default));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));

        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("MOVE", "ALL", "", "0,0", "0.02,0", "VERIFY", ""));
        Assert.Equal(CommandFailure.Drawing, failed.Reason);
        Assert.Matches(@"\njob\.dmc: error VER0008: The program deviates from the drawing by 0\.02\d* mm at ", talk.Said);
        Assert.Contains("\nNOT OK: ", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Origin", "40,-12.5", true)]
    [InlineData("O", "40,-12.5,0", true)]
    [InlineData("Origin", "40,-12", false)]
    [InlineData("Blend", "0.05", false)]
    public async Task A_program_that_goes_to_its_place_by_itself_is_judged_by_the_place_that_is_given(string option, string value, bool isOk)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        var posted = PostedProgram.Create(talk.Session.Document.Current.Drawing!, talk.Session.Document.Current.Settings, PostTable.Find("galil").Post, new Dictionary<string, string> { ["origin"] = "40,-12.5" });
        await File.WriteAllTextAsync(talk.PathOf("job.dmc"), posted.Text);

        Assert.Equal(isOk, await talk.TypeAsync("VERIFY", option, value, "job.dmc") is InputResult.Done);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("VERIFY", "job.dmc"));
    }

    [Fact]
    public async Task Rounded_corners_are_allowed_by_as_much_as_is_said()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        var posted = PostedProgram.Create(talk.Session.Document.Current.Drawing!, talk.Session.Document.Current.Settings, PostTable.Find("gcode").Post, new Dictionary<string, string> { ["blend"] = "0.05" });
        await File.WriteAllTextAsync(talk.PathOf("job.ngc"), posted.Text);

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("VERIFY", "job.ngc"));
        Assert.Contains("error VER0011", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("VERIFY", "Blend", "0.05", "job.ngc"));
    }

    [Fact]
    public async Task A_program_that_is_none_or_not_there_is_named_with_its_file()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("note.txt"), "hello\n");
        Assert.Contains("No drawing is open", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("VERIFY")).Message, StringComparison.Ordinal);
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("VERIFY", "note.txt"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("VERIFY", "nowhere.dmc"));
        Assert.Contains("note.txt(1): error VER0002", talk.Said, StringComparison.Ordinal);
        Assert.Contains("nowhere.dmc: error DOC0001", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task How_far_it_is_is_shown_and_nothing_is_left_of_it()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "POST", "Galil", "job.dmc");
        var seen = new List<double?>();
        talk.Session.Progress.Changed += (_, _) => seen.Add(talk.Session.Progress.Fraction);

        await talk.TypeAsync("VERIFY", "job.dmc");

        Assert.Equal([.. seen.SkipLast(1).Order()], seen.SkipLast(1));
        Assert.NotNull(seen[0]);
        Assert.Null(seen[^1]);
    }

    [Fact]
    public async Task A_stop_while_it_replays_ends_it_and_the_progress()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "POST", "Galil", "job.dmc");
        var stopping = Task.CompletedTask;
        talk.Session.Progress.Changed += (_, _) => stopping = stopping.IsCompleted && talk.Session.Progress.Fraction is not null ? talk.Session.CancelAsync() : stopping;

        var ended = await talk.TypeAsync("VERIFY", "job.dmc");
        await stopping;

        Assert.IsType<InputResult.Cancelled>(ended);
        Assert.DoesNotContain("ok: maximum deviation", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Progress.Fraction);
    }
}
