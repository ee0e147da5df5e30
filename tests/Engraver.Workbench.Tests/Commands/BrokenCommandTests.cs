using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>An exception inside a command: a message, an alarm, no further motion, and a working session.</summary>
public sealed class BrokenCommandTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-broken-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));
    private readonly List<CommandMessage> _said = [];

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task It_ends_as_a_sentence_and_an_alarm_and_the_session_lives(bool late)
    {
        await using var session = Session(late);

        var failed = Assert.IsType<InputResult.Failed>(await session.EnterAsync("BREAKDOWN", _limit.Token));
        Assert.Equal((CommandFailure.Internal, "BREAKDOWN ended with an internal error (KeyNotFoundException: the drawer is empty)."), (failed.Reason, failed.Message));
        Assert.IsType<KeyNotFoundException>(failed.Exception);
        Assert.Contains(_said, message => message.Text.Contains(nameof(BreakCommand), StringComparison.Ordinal)); // At its old position.
        var alarm = Assert.Single(session.Machine.Alarms.Open);
        Assert.Equal((AlarmCause.InternalError, "BREAKDOWN", true), (alarm.Cause, alarm.Where, alarm.NeedsAcknowledging));
        Assert.Equal(PromptView.Idle, session.Prompt);
        Assert.IsType<InputResult.Done>(await session.EnterAsync("GRID", _limit.Token) is InputResult.AwaitingInput ? await session.EnterAsync("OFF", _limit.Token) : new InputResult.Cancelled());
    }

    [Fact]
    public async Task In_a_script_it_ends_the_script_with_its_line()
    {
        await using var session = Session(late: false);
        await File.WriteAllTextAsync(Path.Combine(_folder.FullName, "a.scr"), "GRID OFF\nBREAKDOWN\nGRID ON\n");
        await session.EnterAsync("SCRIPT", _limit.Token);

        var failed = Assert.IsType<InputResult.Failed>(await session.EnterAsync("a.scr", _limit.Token));
        Assert.Contains("a.scr(2)", failed.Message, StringComparison.Ordinal);
        Assert.NotNull(failed.Exception);
        Assert.False(session.View.Current.Grid);
    }

    [Fact]
    public async Task While_a_job_runs_the_machine_is_stopped()
    {
        await using var session = Session(late: false);
        foreach (var input in new[] { "OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", SlowSimulator.Address, "CNCRUN" }) await session.EnterAsync(input, _limit.Token);
        var cutting = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        session.Machine.Changed += (_, _) => { if (session.Machine.Status.ToolCommanded == true) cutting.TrySetResult(); };
        var job = session.EnterAsync("Yes", _limit.Token);
        await cutting.Task.WaitAsync(_limit.Token);

        Assert.EndsWith("The job was stopped.", Assert.IsType<InputResult.Failed>(await session.EnterAsync("BREAKDOWN", _limit.Token)).Message, StringComparison.Ordinal);
        Assert.Equal(CommandFailure.Stopped, Assert.IsType<InputResult.Failed>(await job).Reason);
        Assert.Equal((JobOutcome.Stopped, false), (session.Machine.Runs.LastRun!.Result.Outcome, session.Machine.Status.ToolCommanded!.Value));
    }

    [Fact]
    public async Task A_listener_that_breaks_in_the_middle_of_a_job_ends_it_with_the_machine_at_rest_and_the_tool_off()
    {
        await using var session = Session(late: false);
        foreach (var input in new[] { "OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCRUN" }) await session.EnterAsync(input, _limit.Token);
        var isArmed = true;
        session.Machine.Changed += (_, _) =>
        {
            if (!isArmed || session.Machine.Status is not { State: MachineState.Running, ToolCommanded: true }) return;
            isArmed = false;
            throw new KeyNotFoundException("the window has lost a row");
        };

        var failed = Assert.IsType<InputResult.Failed>(await session.EnterAsync("Yes", _limit.Token));
        Assert.Equal(CommandFailure.Internal, failed.Reason);
        Assert.False(session.Machine.IsRunning);
        Assert.Equal((MachineState.Ready, false, 0.0), (session.Machine.Status.State, session.Machine.Status.ToolCommanded!.Value, session.Machine.Status.Speed!.Value));
        Assert.Contains(session.Machine.Alarms.Open, alarm => alarm.Cause == AlarmCause.InternalError);
    }

    public void Dispose()
    {
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    private CommandSession Session(bool late)
    {
        var built = CommandCatalog.Built();
        var commands = built.All.Select(info => built.Find(info.Name)!).Append(new BreakCommand(late));
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName }, new CommandCatalog(commands));
        session.MessageWritten += (_, message) => { lock (_said) _said.Add(message); };
        return session;
    }

    private sealed class BreakCommand(bool late) : ICommand
    {
        public CommandInfo Info { get; } = new("BREAKDOWN", CommandGroup.Ask) { IsAllowedDuringJob = true };

        public async Task RunAsync(CommandContext context, CancellationToken cancellation)
        {
            if (late) await Task.Yield();
            throw new KeyNotFoundException("the drawer is empty");
        }
    }
}
