using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Inputs queued behind the running command: in order, only after success, and never for commands that move the machine.</summary>
public class TypeAheadTests
{
    private static readonly InputResult s_done = new InputResult.Done();

    [Fact]
    public async Task Nothing_that_acts_on_the_machine_or_runs_other_commands_is_kept_and_everything_else_is()
    {
        await using var talk = new CommandTestSession();
        var ahead = talk.Session.TypeAhead;
        var refused = talk.Session.Catalog.All.Where(info => ahead.RefusalOf(info.Name) is not null).Select(info => info.Name).ToHashSet();

        Assert.Equal(talk.Session.Catalog.All.Where(info => info.StartsMotion || info.Group == CommandGroup.Machine || info.Name == "SCRIPT").Select(info => info.Name).ToHashSet(), refused);
        Assert.Contains("CNCRUN", refused);
        Assert.NotNull(ahead.RefusalOf(" '_cncgoto "));
        Assert.NotNull(ahead.RefusalOf(""));
        Assert.Null(ahead.RefusalOf("10,20"));
    }

    [Fact]
    public async Task What_was_kept_is_run_as_if_it_were_typed_now()
    {
        await using var talk = CommandTestSession.WithDrawing();

        Assert.IsType<InputResult.AwaitingInput>(await talk.Session.TypeAhead.EnterAsync("ERASE", 0, s_done, CancellationToken.None));
        Assert.IsType<InputResult.AwaitingInput>(await talk.Session.TypeAhead.EnterAsync("ALL", 0, s_done, CancellationToken.None));
        await talk.TypeAsync("");

        Assert.Equal(0, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task Behind_a_command_that_failed_or_was_ended_and_behind_Esc_or_a_stop_nothing_is_run()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var ahead = talk.Session.TypeAhead;
        var typedAt = ahead.Flushed;

        Assert.IsType<InputResult.Cancelled>(await ahead.EnterAsync("UNDO", typedAt, new InputResult.Failed(CommandFailure.Usage, "no"), CancellationToken.None));
        Assert.IsType<InputResult.Cancelled>(await ahead.EnterAsync("UNDO", typedAt, new InputResult.Cancelled(), CancellationToken.None));
        Assert.IsType<InputResult.Cancelled>(await ahead.EnterAsync("UNDO", typedAt, new InputResult.NotAccepted("what"), CancellationToken.None));
        ahead.Flush();
        Assert.IsType<InputResult.Cancelled>(await ahead.EnterAsync("UNDO", typedAt, s_done, CancellationToken.None));

        Assert.Equal(4, talk.Said.Split('\n').Count(line => line == "'UNDO' was typed ahead and not run: the command before it failed or was cancelled."));
        Assert.Null(talk.Session.Prompt.Command);
    }

    [Fact]
    public async Task A_question_of_a_command_that_moves_the_machine_is_not_answered_by_what_was_typed_before_it()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("CNCCONNECT", "sim:", "CNCGOTO");
        Assert.Equal("CNCGOTO", talk.Session.Prompt.Command);

        var result = await talk.Session.TypeAhead.EnterAsync("10,10", talk.Session.TypeAhead.Flushed, new InputResult.AwaitingInput(), CancellationToken.None);

        Assert.IsType<InputResult.Cancelled>(result);
        Assert.Contains("'10,10' was typed before the prompt of CNCGOTO appeared. CNCGOTO acts on the machine, so the input was ignored.", talk.Said, StringComparison.Ordinal);
        Assert.Equal(("CNCGOTO", false), (talk.Session.Prompt.Command, talk.Session.Machine.IsRunning));
    }
}
