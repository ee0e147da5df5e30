using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCGOTO moves the machine manually with the watchdog and the stop of a job. The simulated controller is connected over a socket, like a real
/// one.</summary>
public sealed class GoToCommandTests : IAsyncDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-goto-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));
    private readonly List<string> _said = [];
    private SimulatedController _controller = new(new SimulatorOptions { Speed = double.PositiveInfinity });
    private int _port;

    [Fact]
    public async Task CNCGOTO_Start_goes_to_the_drawings_start_and_Work_to_a_place_of_the_drawing()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCGOTO", "12,-4");
        await TypeAsync(session, "CNCZERO", "All");

        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "Work", "3,5"));
        Assert.Equal((15.0, 1.0), At(session));
        Assert.Equal(new Core.Geometry.Point2D(3, 5), session.Machine.Status.WorkPosition);
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "Start"));
        Assert.Equal((12.0, -4.0), At(session));
    }

    [Fact]
    public async Task CNCGOTO_goes_to_a_machine_position_with_the_tool_off_and_leaves_the_job_frame_alone()
    {
        await using var session = await ConnectedAsync();
        await RunAsync(session);
        var rows = _controller.Record.Snapshot().Count;
        var done = session.Machine.Runs.Progress;

        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "-3.5,7"));

        Assert.Equal((-3.5, 7.0), At(session));
        Assert.Equal(-3.5, session.Machine.Status.WorkPosition!.Value.X, precision: 9);
        Assert.Equal((done, 1), (session.Machine.Runs.Progress, session.Machine.Status.Progress?.SegmentsDone)); // of the job, not of the move
        var moved = _controller.Record.Snapshot().Skip(rows).ToList();
        Assert.True(Moves(moved) > 0);
        Assert.All(moved, sample => Assert.Equal(0, sample.Outputs & 1));
    }

    [Fact]
    public async Task What_cannot_move_is_refused_with_what_to_do()
    {
        await using var session = NewSession();
        Assert.Contains("CNCCONNECT", await FailedAsync(session, "CNCGOTO"), StringComparison.Ordinal);
        await ConnectAsync(session);
        Assert.Contains("G54 is not set. Set it with CNCZERO", await FailedAsync(session, "CNCGOTO", "Start"), StringComparison.Ordinal);
        Assert.Contains("no park position", await FailedAsync(session, "CNCGOTO", "Park"), StringComparison.Ordinal);
        Assert.Contains("32 bits", await FailedAsync(session, "CNCGOTO", "3000000,0"), StringComparison.Ordinal);
        await TypeAsync(session, "CNCMOTORS", "OFF");
        Assert.Contains("CNCMOTORS ON", await FailedAsync(session, "CNCGOTO", "1,1"), StringComparison.Ordinal);
        Assert.Equal(0, Moves(_controller.Record.Snapshot()));
    }

    [Fact]
    public async Task A_place_of_the_drawing_is_refused_when_the_controller_no_longer_counts_from_the_origins_zero()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCGOTO", "12,-4");
        await TypeAsync(session, "CNCZERO", "All");
        await session.Machine.Connection.Terminal.TypeAsync("cncmark=7", _limit.Token); // as a power cycle leaves it: not ours
        var rows = _controller.Record.Snapshot().Count;

        Assert.Contains("G54", await FailedAsync(session, "CNCGOTO", "Work", "3,5"), StringComparison.Ordinal);
        Assert.Contains("G54", await FailedAsync(session, "CNCGOTO", "Start"), StringComparison.Ordinal);
        Assert.Contains("G54", await FailedAsync(session, "CNCORIGIN", "Typed", "1,2", "Yes"), StringComparison.Ordinal); // An old number would be another position now.
        Assert.Equal(0, Moves(_controller.Record.Snapshot().Skip(rows)));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "11,-4")); // a machine position needs no origin
    }

    [Fact]
    public async Task CNCGOTO_Clearance_raises_a_tool_that_an_axis_holds_and_says_so_where_none_does()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCGOTO", "12,-4");
        Assert.Contains("no clearance height", await FailedAsync(session, "CNCGOTO", "Clearance"), StringComparison.Ordinal);
        await TypeAsync(session, "CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        await TypeAsync(session, "CNCZERO", "All");

        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "Clearance"));
        var rest = _controller.Record.Snapshot()[^1];
        Assert.Equal((12000L, -4000L, 3200L), ((long)rest.A, (long)rest.B, (long)rest.C));
    }

    [Theory]
    [InlineData("Work", "30,0")]
    [InlineData("42,-4")]
    public async Task A_tool_that_an_axis_holds_is_at_its_clearance_height_before_it_travels_over_the_work(params string[] place)
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCGOTO", "12,-4");
        await TypeAsync(session, "CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        await TypeAsync(session, "CNCZERO", "All");
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "Z-", "2"));
        var rows = _controller.Record.Snapshot().Count;

        Assert.IsType<InputResult.Done>(await TypeAsync(session, ["CNCGOTO", .. place]));

        var way = _controller.Record.Snapshot().Skip(rows).ToList();
        Assert.Equal((42000L, -4000L, 3200L), ((long)way[^1].A, (long)way[^1].B, (long)way[^1].C));
        Assert.All(way.Where(sample => sample.A is > 12000 and < 42000), sample => Assert.Equal(3200, sample.C));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "Z+", "6"));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "Start"));
        Assert.Equal(8000, _controller.Record.Snapshot()[^1].C); // A higher tool is not lowered.
    }

    [Fact]
    public async Task Over_work_whose_height_nobody_set_a_tool_that_an_axis_holds_does_not_travel()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        await TypeAsync(session, "CNCZERO", "X");
        await TypeAsync(session, "CNCJOG", "Z-", "2");
        var rows = _controller.Record.Snapshot().Count;

        Assert.Contains("has no height", await FailedAsync(session, "CNCGOTO", "30,0"), StringComparison.Ordinal);
        Assert.Equal(0, Moves(_controller.Record.Snapshot().Skip(rows)));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "1,0"));
        await TypeAsync(session, "CNCZERO", "Z");
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "30,0"));
    }

    /// <summary>The power-on position is not the work origin, although the controller's position is 0 there.</summary>
    [Fact]
    public async Task A_tool_that_was_switched_on_somewhere_does_not_travel_before_the_height_of_the_work_is_set()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));

        Assert.Contains("has no height", await FailedAsync(session, "CNCGOTO", "30,0"), StringComparison.Ordinal);
        Assert.DoesNotContain(_controller.Record.Snapshot(), sample => (sample.A, sample.B, sample.C) is not (0, 0, 0)); // It was not raised either.
        await TypeAsync(session, "CNCZERO", "Z");
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "30,0"));
        Assert.Equal(3200, _controller.Record.Snapshot()[^1].C);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_script_moves_a_real_machine_no_more_than_it_starts_one(bool desktop)
    {
        await using var session = await ConnectedAsync(desktop);
        await File.WriteAllTextAsync(Path.Combine(_folder.FullName, "go.scr"), "CNCGOTO 1,1\n");
        await File.WriteAllTextAsync(Path.Combine(_folder.FullName, "armed.scr"), "CNCARM Stream\nCNCGOTO 1,1\n");

        Assert.IsType<InputResult.Failed>(await TypeAsync(session, "SCRIPT", "go.scr"));
        Assert.Equal(0, Moves(_controller.Record.Snapshot()));
        var armed = await TypeAsync(session, "SCRIPT", "armed.scr");
        if (desktop) Assert.IsType<InputResult.Failed>(armed);
        else Assert.IsType<InputResult.Done>(armed);
        Assert.Equal(!desktop, Moves(_controller.Record.Snapshot()) > 0);
    }

    [Fact]
    public async Task A_stop_in_mid_move_stops_the_machine_first()
    {
        _controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        await using var session = await ConnectedAsync();
        var moving = TypeAsync(session, "CNCGOTO", "100,0");
        await SeenAsync(session.Machine, status => status is { State: MachineState.Moving, MachinePosition.X: > 5 });

        foreach (var meanwhile in (string[])["CNCGOTO", "CNCZERO", "CNCORIGIN"]) Assert.IsType<InputResult.NotAccepted>(await session.EnterAsync(meanwhile, CancellationToken.None));
        Assert.True(session.Machine.Controls.Stop());

        Assert.Equal(CommandFailure.Stopped, Assert.IsType<InputResult.Failed>(await moving.WaitAsync(_limit.Token)).Reason);
        Assert.InRange(At(session).X, 5.0, 99.0);
        Assert.Equal((true, 0), (_controller.Status.IsIdle, (int)_controller.Status.Outputs));
    }

    [Fact]
    public async Task When_the_link_is_lost_in_mid_move_the_watchdog_in_the_controller_stops_the_machine()
    {
        _controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        await using var session = await ConnectedAsync();
        var moving = TypeAsync(session, "CNCGOTO", "500,0");
        await SeenAsync(session.Machine, status => status is { State: MachineState.Moving, MachinePosition.X: > 5 });

        _controller.DropConnections();

        Assert.Equal(CommandFailure.LinkLost, Assert.IsType<InputResult.Failed>(await moving.WaitAsync(_limit.Token)).Reason);
        await SeenAsync(session.Machine, status => status.State == MachineState.NoOrigin); // The polling connection, whose links were cut too, is reopened.
        Assert.InRange(At(session).X, 5.0, 499.0);
        Assert.Equal(0, (int)_controller.Status.Outputs);
    }

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    private static (double X, double Y) At(CommandSession session) => (session.Machine.Status.MachinePosition!.Value.X, session.Machine.Status.MachinePosition!.Value.Y);

    private static int Moves(IEnumerable<MotionSample> samples) => samples.Zip(samples.Skip(1)).Count(pair => (pair.First.A, pair.First.B) != (pair.Second.A, pair.Second.B));

    private static List<(int, int)> Cut(IEnumerable<MotionSample> samples) => [.. samples.Where(sample => (sample.Outputs & 1) != 0).Select(sample => ((int)sample.A, (int)sample.B)).Distinct()];

    private CommandSession NewSession(bool desktop = false)
    {
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName, RunNeedsArming = desktop }, CommandCatalog.Built());
        session.MessageWritten += (_, message) => _said.Add(message.Text);
        session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 5, 0).Build() });
        return session;
    }

    private async Task<CommandSession> ConnectedAsync(bool desktop = false)
    {
        var session = NewSession(desktop);
        await ConnectAsync(session);
        return session;
    }

    private async Task ConnectAsync(CommandSession session)
    {
        if (_port == 0) _port = (await _controller.ListenTcpAsync(0, _limit.Token)).Port;
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCCONNECT", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{_port}")));
    }

    private static async Task RunAsync(CommandSession session)
    {
        await TypeAsync(session, "CNCARM", "Stream");
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCRUN"));
        Assert.Equal(JobOutcome.Complete, session.Machine.Runs.LastRun!.Result.Outcome);
    }

    private static async Task<InputResult> TypeAsync(CommandSession session, params string[] inputs)
    {
        InputResult result = new InputResult.Done();
        foreach (var input in inputs) result = await session.EnterAsync(input, CancellationToken.None);
        return result;
    }

    private static async Task<string> FailedAsync(CommandSession session, params string[] inputs) => Assert.IsType<InputResult.Failed>(await TypeAsync(session, inputs)).Message;

    private async Task SeenAsync(MachineSession machine, Func<MachineStatus, bool> wanted)
    {
        var seen = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        void OnChanged(object? sender, EventArgs e)
        {
            if (wanted(machine.Status)) seen.TrySetResult();
        }

        machine.Changed += OnChanged;
        OnChanged(null, EventArgs.Empty);
        await seen.Task.WaitAsync(_limit.Token);
        machine.Changed -= OnChanged;
    }
}
