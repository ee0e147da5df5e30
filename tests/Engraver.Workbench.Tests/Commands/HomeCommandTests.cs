using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCHOME, and work origins that remain valid after a power cycle because of homing. The simulated machine is switched on at another position each
/// time; its switches do not move.</summary>
public sealed class HomeCommandTests : IAsyncDisposable
{
    private const int Number = 2143;
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-home-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));
    private readonly List<string> _said = [];
    private SimulatedController _controller = SwitchedOn(20, 15);

    private static MachineProfile Profile { get; } = MachineProfile.Default with
    {
        Axes = new MachineAxes(
            new MachineAxis('A', 1000) { Homing = new AxisHoming { By = HomingMark.Limit, Zero = -1, BackOff = 1, Order = 1 }, Travel = new AxisTravel(0, 80) },
            new MachineAxis('B', 1000) { Homing = new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 40, BackOff = 2 }, Travel = new AxisTravel(0, 39) }),
    };

    [Fact]
    public async Task An_origin_that_was_set_on_a_homed_machine_is_the_same_place_after_a_power_cycle_and_homing()
    {
        List<(int, int)> first;
        await using (var session = await ConnectedAsync())
        {
            Assert.Equal((MachineState.NotHomed, false), (session.Machine.Status.State, session.Machine.Status.IsHomed));
            Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCHOME", "Yes"));
            Assert.Equal((0.0, 38.0, true), (At(session).X, At(session).Y, session.Machine.Status.IsHomed));
            await TypeAsync(session, "CNCGOTO", "30,10");
            await TypeAsync(session, "CNCZERO", "All");
            first = await CutAsync(session);
            Assert.Contains((30000, 10000), first);
        }

        await PowerCycleAsync(7, 33);
        await using var later = await ConnectedAsync();
        Assert.Equal(MachineState.NotHomed, later.Machine.Status.State);
        Assert.IsType<InputResult.Failed>(await TypeAsync(later, "CNCARM", "Stream"));
        Assert.Contains(_said, line => line.Contains("not homed", StringComparison.Ordinal) && line.Contains("CNCHOME", StringComparison.Ordinal));
        Assert.Equal(0, Moves(_controller.Record.Snapshot()));
        Assert.IsType<InputResult.Done>(await TypeAsync(later, "CNCHOME", "Yes"));
        Assert.Equal(first, await CutAsync(later));
    }

    [Fact]
    public async Task A_machine_that_is_homed_stays_homed_for_the_next_session_and_not_behind_a_power_cycle()
    {
        await using (var session = await ConnectedAsync()) await TypeAsync(session, "CNCHOME", "Yes");
        await using (var session = await ConnectedAsync()) Assert.True(session.Machine.Status.IsHomed);
        await using (var other = await ConnectedAsync(Profile with { Axes = Profile.Axes with { X = Profile.Axes.X with { Homing = Profile.Axes.X.Homing! with { Zero = 5 } } } })) Assert.False(other.Machine.Status.IsHomed);
        await PowerCycleAsync(20, 15);
        await using (var session = await ConnectedAsync()) Assert.False(session.Machine.Status.IsHomed);
    }

    [Fact]
    public async Task Origins_that_were_set_before_the_first_homing_move_with_the_counts_and_those_of_a_lost_zero_are_forgotten_and_named()
    {
        await using (var session = await ConnectedAsync(Profile with { Axes = Profile.Axes with { X = Profile.Axes.X with { Travel = null, Homing = null }, Y = Profile.Axes.Y with { Travel = null, Homing = null } } }))
        {
            await TypeAsync(session, "CNCGOTO", "3,4");
            await TypeAsync(session, "CNCZERO", "All"); // 23, 19 by the place of the switches
        }

        await using (var session = await ConnectedAsync())
        {
            Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCHOME", "Yes"));
            var origin = session.Machine.Connection.Lease!.Memory.ActiveOrigin!;
            Assert.InRange(origin.X!.Value, 22997, 23003);
            Assert.InRange(origin.Y!.Value, 18997, 19003);
        }

        await using (var session = await ConnectedAsync(Profile with { Axes = Profile.Axes with { X = Profile.Axes.X with { Travel = null, Homing = null }, Y = Profile.Axes.Y with { Travel = null, Homing = null } } }))
        {
            Assert.Contains("homed with another machine profile", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCZERO", "X", "Yes")).Message, StringComparison.Ordinal);
        }

        await using (var session = await ConnectedAsync())
        {
            await TypeAsync(session, "CNCORIGIN", "G55");
            await TypeAsync(session, "CNCZERO", "All");
        }

        await PowerCycleAsync(20, 15);
        await using var last = await ConnectedAsync(Profile with { Axes = Profile.Axes with { X = Profile.Axes.X with { Homing = Profile.Axes.X.Homing! with { Zero = -2, BackOff = 3 } } } });
        await TypeAsync(last, "CNCHOME", "Yes");
        Assert.Contains(_said, line => line.Contains("G54, G55", StringComparison.Ordinal) && line.Contains("CNCZERO", StringComparison.Ordinal));
        Assert.Empty(last.Machine.Connection.Lease!.Memory.Origins);
        Assert.True(last.Machine.Status.IsHomed);
    }

    [Fact]
    public async Task A_homing_that_does_not_come_to_its_end_leaves_a_machine_that_is_not_homed_whatever_was_before()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCHOME", "Yes");
        await TypeAsync(session, "CNCZERO", "All");
        session.Machine.Profile = Profile with { Axes = Profile.Axes with { Y = Profile.Axes.Y with { Homing = Profile.Axes.Y.Homing! with { Seconds = 0.01 } } } };

        var failed = Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCHOME", "Yes"));

        Assert.Contains("was not homed within", failed.Message, StringComparison.Ordinal);
        Assert.Equal(MachineState.NotHomed, session.Machine.Status.State);
        Assert.Contains("not homed", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCGOTO", "1,1")).Message, StringComparison.Ordinal);
        session.Machine.Profile = Profile;
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCHOME", "Yes"));
        Assert.Equal(38000, session.Machine.Connection.Lease!.Memory.ActiveOrigin!.Y);
    }

    [Fact]
    public async Task A_homing_that_was_refused_before_anything_moved_changes_nothing()
    {
        await using var session = await ConnectedAsync();
        await TypeAsync(session, "CNCHOME", "Yes");
        var before = session.Machine.Connection.Lease!.Memory;
        await TypeAsync(session, "CNCMOTORS", "OFF");

        Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCHOME", "Yes"));
        Assert.Equal(JobOutcome.Refused, (await session.Machine.Hand.HomeAsync(Path.Combine(_folder.FullName, "home.jsonl"), _limit.Token)).Result.Outcome);

        Assert.Equal((before.HomedAs, before.Mark, ""), (session.Machine.Connection.Lease!.Memory.HomedAs, session.Machine.Connection.Lease!.Memory.Mark, session.Machine.Connection.Lease!.Memory.Lost));
    }

    [Fact]
    public async Task A_machine_that_is_not_homed_is_jogged_without_limits_and_goes_to_no_place()
    {
        await using var session = await ConnectedAsync();

        Assert.Contains("not homed", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCGOTO", "1,1")).Message, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "-5,0")); // Outside the travel if it were homed here.
        Assert.Equal(-5.0, At(session).X);
    }

    [Fact]
    public async Task Without_homing_in_the_profile_there_is_nothing_to_home_and_no_state_of_it()
    {
        await using var session = await ConnectedAsync(MachineProfile.Default);

        Assert.Null(session.Machine.Status.IsHomed);
        Assert.Contains("homing", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCHOME")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_simulated_machine_has_its_switches_where_the_profile_says()
    {
        await using var session = NewSession(Profile);
        await TypeAsync(session, "CNCCONNECT", "sim:?speed=max");

        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCHOME", "Yes"));
        Assert.Equal((0.0, 38.0), At(session));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "80,0"));
    }

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    /// <summary>A machine with switches at -1 mm (A) and 40 mm (B), switched on at this place.</summary>
    private static SimulatedController SwitchedOn(int x, int y) => new(new SimulatorOptions
    {
        Speed = double.PositiveInfinity,
        SerialNumber = Number,
        Switches =
        [
            new AxisSwitches(0) { ReverseLimitAt = (-1 - x) * 1000, ForwardLimitAt = (90 - x) * 1000 },
            new AxisSwitches(1) { HomeAt = (40 - y) * 1000, ReverseLimitAt = (-5 - y) * 1000, ForwardLimitAt = (45 - y) * 1000 },
        ],
    });

    private async Task PowerCycleAsync(int x, int y)
    {
        await _controller.DisposeAsync();
        _controller = SwitchedOn(x, y);
    }

    private static (double X, double Y) At(CommandSession session) => (session.Machine.Status.MachinePosition!.Value.X, session.Machine.Status.MachinePosition!.Value.Y);

    private static int Moves(IReadOnlyList<MotionSample> rows) => rows.Zip(rows.Skip(1)).Count(pair => (pair.First.A, pair.First.B) != (pair.Second.A, pair.Second.B));

    private async Task<List<(int, int)>> CutAsync(CommandSession session)
    {
        var rows = _controller.Record.Count;
        await TypeAsync(session, "CNCARM", "Stream");
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCRUN"));
        return [.. _controller.Record.Snapshot().Skip(rows).Where(row => (row.Outputs & 1) != 0).Select(row => (row.A, row.B)).Distinct()];
    }

    private CommandSession NewSession(MachineProfile profile)
    {
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName }, CommandCatalog.Built());
        session.MessageWritten += (_, message) => _said.Add(message.Text);
        var state = new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 5, 0).Build() };
        session.Document.Commit("OPEN", state with { Settings = state.Settings with { Machine = profile } });
        return session;
    }

    private async Task<CommandSession> ConnectedAsync(MachineProfile? profile = null)
    {
        var session = NewSession(profile ?? Profile);
        var port = (await _controller.ListenTcpAsync(0, _limit.Token)).Port;
        var clock = (await _controller.ListenClockAsync(_limit.Token)).Port; // A busy computer must not count as a silent host.
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCCONNECT", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}")));
        return session;
    }

    private static async Task<InputResult> TypeAsync(CommandSession session, params string[] inputs)
    {
        InputResult result = new InputResult.Done();
        foreach (var input in inputs) result = await session.EnterAsync(input, CancellationToken.None);
        return result;
    }
}
