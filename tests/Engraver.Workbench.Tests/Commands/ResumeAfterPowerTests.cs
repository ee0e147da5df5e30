using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>The power fails in the middle of a cut with a tool axis: switched on elsewhere, homed and resumed, the rest is cut at the position of the work.
/// Checked by the records before and after the power failure, in machine counts.</summary>
public sealed class ResumeAfterPowerTests : IAsyncDisposable
{
    private const int TopOfWork = 4000;
    private const int Depth = 400;
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-power-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));
    private readonly List<string> _said = [];
    private SimulatedController _controller = SwitchedOn(20, 15, 12);

    private static MachineProfile Profile { get; } = MachineProfile.Default with
    {
        Axes = new MachineAxes(
            new MachineAxis('A', 1000) { Homing = new AxisHoming { By = HomingMark.Limit, Zero = -1, BackOff = 1, Order = 1 }, Travel = new AxisTravel(0, 80) },
            new MachineAxis('B', 1000) { Homing = new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 40, BackOff = 2, Order = 2 }, Travel = new AxisTravel(0, 39) },
            new MachineAxis('C', 800) { Homing = new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 20, BackOff = 2, Order = 0 } }),
        Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, CutDepth = 0.5, PlungeMmPerMinute = 240.0 },
        Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.2 },
    };

    [Theory]
    [InlineData("Stream")]
    [InlineData("Calls")]
    [InlineData("Program")]
    public async Task Homed_again_the_rest_is_cut_to_the_count_where_the_work_is(string mode)
    {
        List<MotionSample> first;
        string journal;
        await using (var session = await ConnectedAsync())
        {
            await TypeAsync(session, "CNCHOME", "Yes", "CNCGOTO", "30,10", "CNCJOG", "Z-", "13", "CNCZERO", "All");
            Assert.Equal(new CountsPoint(30000, 10000, TopOfWork), Origin(session));
            await TypeAsync(session, "CNCARM", mode);
            var rows = _controller.Record.Count;
            FailAt(session, progress => progress.X > 12000);
            Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCRUN"));
            first = [.. _controller.Record.Snapshot().Skip(rows)];
            Assert.Equal(JobOutcome.LinkLost, session.Machine.Runs.LastRun!.Result.Outcome);
            journal = session.Machine.Runs.LastRun.Journal!;
        }

        await _controller.DisposeAsync();
        _controller = SwitchedOn(44, 8, 15);
        await using var later = await ConnectedAsync();
        Assert.Equal(MachineState.NotHomed, later.Machine.Status.State);
        Assert.IsType<InputResult.Done>(await TypeAsync(later, "CNCRESUME", journal));
        await TypeAsync(later, "CNCARM", "");
        Assert.Null(later.Machine.Arming.Armed); // not before it is homed
        Assert.IsType<InputResult.Done>(await TypeAsync(later, "CNCHOME", "Yes"));
        Assert.IsType<InputResult.Done>(await TypeAsync(later, "CNCRESUME", journal));
        await TypeAsync(later, "CNCARM", "");
        Assert.True(later.Machine.Arming.Armed is not null, string.Join('\n', _said));
        var before = _controller.Record.Count;

        Assert.IsType<InputResult.Done>(await TypeAsync(later, "CNCRUN"));

        var run = later.Machine.Runs.LastRun!;
        Assert.Equal((JobOutcome.Complete, mode), (run.Result.Outcome, mode));
        Assert.True(run.ResumedFrom is { Along: > 8000.0 }, run.ResumedFrom.ToString());
        AssertCut([.. first, .. _controller.Record.Snapshot().Skip(before)]);
    }

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    /// <summary>An L of 30 and 20 mm from the origin, half a millimetre deep: every sample in the work is on or above it, and every position was
    /// reached.</summary>
    private static void AssertCut(IReadOnlyList<MotionSample> record)
    {
        var deep = record.Where(sample => sample.C < TopOfWork).ToList();
        Assert.All(deep, sample => Assert.True(
            (Math.Abs(sample.B - 10000) <= 2 && sample.A is >= 29998 and <= 60002) || (Math.Abs(sample.A - 60000) <= 2 && sample.B is >= 9998 and <= 30002) || (sample.A >= 59970 && sample.B <= 10030), // the corner is rounded
            $"{sample.A},{sample.B},{sample.C} lies beside the drawing"));
        var cut = deep.Where(sample => Math.Abs(sample.C - (TopOfWork - Depth)) <= 2).ToList();
        Assert.Equal(TopOfWork - Depth, deep.Min(sample => sample.C));
        AssertPassed([.. cut.Where(sample => Math.Abs(sample.B - 10000) <= 2).Select(sample => sample.A)], 30000, 60000);
        AssertPassed([.. cut.Where(sample => Math.Abs(sample.A - 60000) <= 2).Select(sample => sample.B)], 10000, 30000);
        Assert.All(deep, sample => Assert.Equal(4, sample.Outputs & 4)); // the spindle turned
    }

    /// <summary>No gap between neighbouring samples is longer than the feed in two samples.</summary>
    private static void AssertPassed(IEnumerable<int> places, int from, int to)
    {
        var sorted = places.Append(from).Append(to).Order().ToList();
        Assert.InRange(sorted.Zip(sorted.Skip(1)).Max(pair => pair.Second - pair.First), 1, 45);
    }

    /// <summary>The power fails: the controller stops answering.</summary>
    private void FailAt(CommandSession session, Func<JobProgress, bool> when)
    {
        var failed = false;
        session.Machine.Changed += (_, _) =>
        {
            if (failed || session.Machine.Runs.Progress is not { ToolOn: true } progress || !when(progress)) return;
            failed = true;
            _controller.DropConnections();
        };
    }

    private static CountsPoint Origin(CommandSession session) => session.Machine.Connection.Lease!.Memory.ActiveOrigin is { X: { } x, Y: { } y, Z: { } z } ? new CountsPoint(x, y, z) : default;

    /// <summary>A machine with switches at -1 mm (A), 40 mm (B) and 20 mm (C), switched on at this place.</summary>
    private static SimulatedController SwitchedOn(int x, int y, int z) => new(new SimulatorOptions
    {
        Speed = double.PositiveInfinity,
        SerialNumber = 2143,
        Switches =
        [
            new AxisSwitches(0) { ReverseLimitAt = (-1 - x) * 1000, ForwardLimitAt = (90 - x) * 1000 },
            new AxisSwitches(1) { HomeAt = (40 - y) * 1000, ReverseLimitAt = (-5 - y) * 1000, ForwardLimitAt = (45 - y) * 1000 },
            new AxisSwitches(2) { HomeAt = (20 - z) * 800, ReverseLimitAt = (-5 - z) * 800, ForwardLimitAt = (25 - z) * 800 },
        ],
    });

    private async Task<CommandSession> ConnectedAsync()
    {
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName }, CommandCatalog.Built());
        session.MessageWritten += (_, message) => _said.Add(message.Text);
        var state = new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 30, 0).Line(30, 0, 30, 20).Build() };
        session.Document.Commit("OPEN", state with { Settings = state.Settings with { Machine = Profile } });
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
