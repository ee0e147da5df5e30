using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Who may start a machine that is not simulated. The controller of the test is simulated, but connected over a socket, so that the session cannot
/// know.</summary>
public sealed class ScriptedStartTests : IAsyncDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-start-");
    private readonly SimulatedController _controller = new(new SimulatorOptions { Speed = double.PositiveInfinity });
    private readonly List<string> _said = [];

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_script_that_has_not_armed_moves_nothing(bool desktop)
    {
        await using var session = await SessionAsync(desktop, "CNCRUN\nYes\n");

        Assert.Equal(CommandFailure.Usage, Assert.IsType<InputResult.Failed>(await RunScriptAsync(session)).Reason);
        AssertNothingMoved(session);
    }

    [Fact]
    public async Task A_headless_script_that_arms_on_the_checklist_may_start()
    {
        await using var session = await SessionAsync(desktop: false, "CNCARM Stream\nCNCRUN\n");

        Assert.IsType<InputResult.Done>(await RunScriptAsync(session));
        Assert.Equal(JobOutcome.Complete, session.Machine.Runs.LastRun!.Result.Outcome);
    }

    [Fact]
    public async Task A_checklist_that_has_not_passed_ends_a_headless_script()
    {
        await using var session = await SessionAsync(desktop: false, "CNCMOTORS OFF\nCNCARM Stream\nCNCRUN\n");

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await RunScriptAsync(session)).Reason);
        AssertNothingMoved(session);
    }

    [Fact]
    public async Task In_the_desktop_a_script_may_arm_and_a_hand_starts()
    {
        await using var session = await SessionAsync(desktop: true, "CNCARM Stream\nCNCRUN\n");

        Assert.Contains("START", Assert.IsType<InputResult.Failed>(await RunScriptAsync(session)).Message, StringComparison.Ordinal);
        AssertNothingMoved(session);
        Assert.NotNull(session.Machine.Arming.Armed);
        Assert.IsType<InputResult.Done>(await session.EnterAsync("CNCRUN", CancellationToken.None));
        Assert.Equal(JobOutcome.Complete, session.Machine.Runs.LastRun!.Result.Outcome);
    }

    [Fact]
    public async Task In_the_desktop_pasted_lines_start_no_more_than_a_script()
    {
        await using var session = await SessionAsync(desktop: true, "");
        await RunScriptAsync(session);

        var end = Assert.IsType<InputResult.Failed>(await session.EnterLinesAsync("CNCARM Stream\r\nCNCRUN\r\n", CancellationToken.None));

        Assert.Contains("pasted lines(2)", end.Message, StringComparison.Ordinal);
        Assert.Contains("START", end.Message, StringComparison.Ordinal);
        Assert.Contains(_said, text => text == end.Message);
        AssertNothingMoved(session);
        Assert.NotNull(session.Machine.Arming.Armed);
    }

    [Fact]
    public async Task The_help_of_CNCRUN_says_so()
    {
        await using var session = await SessionAsync(desktop: true, "HELP CNCRUN\n");
        await RunScriptAsync(session);

        Assert.Contains(_said, text => text.Contains("in the operator desktop, a script cannot start a real machine.", StringComparison.Ordinal));
    }

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _folder.Delete(recursive: true);
    }

    private async Task<CommandSession> SessionAsync(bool desktop, string script)
    {
        var end = await _controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await _controller.ListenClockAsync(CancellationToken.None);
        await File.WriteAllTextAsync(Path.Combine(_folder.FullName, "job.scr"), string.Create(CultureInfo.InvariantCulture, $"CNCCONNECT tcp://127.0.0.1:{end.Port}?clock={clock.Port}\n{script}"));
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName, RunNeedsArming = desktop }, CommandCatalog.Built());
        session.MessageWritten += (_, message) => _said.Add(message.Text);
        session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 5, 0).Build() });
        return session;
    }

    private static async Task<InputResult> RunScriptAsync(CommandSession session)
    {
        await session.EnterAsync("SCRIPT", CancellationToken.None);
        return await session.EnterAsync("job.scr", CancellationToken.None);
    }

    private void AssertNothingMoved(CommandSession session)
    {
        Assert.Null(session.Machine.Runs.LastRun);
        Assert.All(_controller.Record.Snapshot(), sample => Assert.Equal((0, 0), (sample.A, sample.B)));
    }
}
