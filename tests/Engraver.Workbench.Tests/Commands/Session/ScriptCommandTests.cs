using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Session;

public class ScriptCommandTests
{
    [Fact]
    public async Task A_script_may_call_another_and_goes_on_after_it()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("outer.scr"), "MOVE ALL\n\n0,0 1,0\nSCRIPT inner.scr\nMOVE P\n\n0,0 4,0\n");
        await File.WriteAllTextAsync(talk.PathOf("inner.scr"), "MOVE P\n\n0,0 2,0\n");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SCRIPT", "outer.scr"));
        Assert.Equal(7, talk.State.Drawing!.Parts[0].A);
    }

    [Fact]
    public async Task A_script_that_calls_itself_ends_with_a_sentence()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("loop.scr"), "SCRIPT loop.scr\n");

        Assert.Contains("whether a script calls itself.", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SCRIPT", "loop.scr")).Message, StringComparison.Ordinal);
        Assert.Equal(PromptView.Idle, talk.Session.Prompt);
    }

    [Fact]
    public async Task What_fails_ends_the_script_with_file_and_line_and_what_was_done_stays()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("bad.scr"), "; first\nMOVE ALL\n\n0,0 1,0\nMOVE P\n\n0,0 there\nERASE ALL\n\n");
        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SCRIPT", "bad.scr"));

        Assert.Contains("bad.scr(7): 'there': ", failed.Message, StringComparison.Ordinal);
        Assert.Equal((PromptView.Idle, 4, 1.0), (talk.Session.Prompt, talk.State.Drawing!.Entities.Count, talk.State.Drawing.Parts[0].A));
    }

    [Fact]
    public async Task A_script_may_leave_a_command_that_still_asks()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("half.scr"), "MOVE ALL\n\n");

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("SCRIPT", "half.scr"));
        Assert.Equal("MOVE", talk.Session.Prompt.Command);
    }
}
