using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Origins;

/// <summary>The same job cuts at the same position, whatever happened in between. The simulated controller is connected over a socket and keeps its position
/// between runs, like a real one; each run is a separate host.</summary>
public sealed class WorkOriginTests : IAsyncDisposable
{
    private const int Number = 4711;
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-origin-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));
    private readonly ManualTimeProvider _clock = new();
    private SimulatedController _controller;
    private ControllerAddress? _address;
    private int _runs;

    public WorkOriginTests() => _controller = NewController();

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task Three_runs_in_a_row_cut_the_same_place_also_after_a_stop_in_the_middle(JobMode mode)
    {
        var first = await CutAsync(mode);
        var second = await CutAsync(mode);
        await StoppedAsync(mode);
        Assert.NotEqual((0L, 0L), Position);
        var third = await CutAsync(mode);

        Assert.NotEmpty(first);
        Assert.Equal(first, second);
        Assert.Equal(first, third);
        Assert.Equal((0L, 0L), Position); // Back at the drawing's start.
    }

    [Fact]
    public async Task A_job_goes_to_the_origin_that_was_set_and_ends_where_it_is_told_to()
    {
        await ActAsync(machine => machine.Origins.SetAsync((memory, _) => memory.WithOrigin("G54", 20000, -5000, null), _limit.Token));
        var moved = await CutAsync(JobMode.Stream);
        Assert.Equal((20000L, -5000L), Position);

        var there = await CutAsync(JobMode.Stream, options => options with { Finish = FinishPlace.Stay });
        Assert.Equal((35000L, 5000L), Position);
        var given = await CutAsync(JobMode.Stream, options => options with { Origin = new OriginRequest.MachinePoint(new Core.Geometry.Point2D(1, 2)) });
        Assert.Equal((1000L, 2000L), Position);

        Assert.Equal(moved, there);
        Assert.Equal([.. given.Select(at => (at.Item1 + 19000, at.Item2 - 7000))], moved);
        var park = MachineProfile.Default with { ParkX = -8.0, ParkY = 3.0 };
        await CutAsync(JobMode.Stream, options => options with { Finish = FinishPlace.Park }, park);
        Assert.Equal((-8000L, 3000L), Position);
    }

    [Fact]
    public async Task Another_controller_of_the_same_address_is_another_machine()
    {
        await ActAsync(machine => machine.Origins.SetAsync((memory, _) => memory.WithOrigin("G54", 20000, -5000, null), _limit.Token));
        await ReplaceAsync(Number + 1);

        await CutAsync(JobMode.Stream);

        Assert.Equal((0L, 0L), Position);
    }

    [Fact]
    public async Task After_a_power_cycle_an_origin_that_was_set_is_refused_and_nothing_moves_until_it_is_set_again()
    {
        await ActAsync(machine => machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X + 700, here.Position.Y, null), _limit.Token));
        await CutAsync(JobMode.Stream);
        await ReplaceAsync(Number);

        var refused = await RunAsync(JobMode.Stream);

        Assert.Equal(JobOutcome.Refused, refused.Result.Outcome);
        Assert.Equal("JOB0009", refused.Placement!.Refusal!.Id);
        Assert.DoesNotContain(_controller.Record.Snapshot(), sample => sample.Outputs != 0 || sample.A != 0 || sample.B != 0);
        await ActAsync(machine => machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X, here.Position.Y, null), _limit.Token));
        await CutAsync(JobMode.Stream);
        Assert.Equal((0L, 0L), Position);
    }

    [Fact]
    public async Task A_host_that_died_in_the_middle_of_a_job_leaves_the_origin_and_a_power_cycle_then_is_no_fresh_machine()
    {
        await CutAsync(JobMode.Stream);
        var file = Directory.GetFiles(_folder.FullName, "*.json").Single();
        var text = await File.ReadAllTextAsync(file);
        Assert.Contains("\"moving\": false", text, StringComparison.Ordinal);
        var moving = System.Text.RegularExpressions.Regex.Replace(text.Replace("\"moving\": false", "\"moving\": true", StringComparison.Ordinal), ",\\s*\"sum\": \"[0-9a-f]*\"", ""); // As written by a host of an older version before it moves.
        await File.WriteAllTextAsync(file, moving);

        Assert.NotEmpty(await CutAsync(JobMode.Stream)); // the controller was not switched off
        await File.WriteAllTextAsync(file, moving);
        await ReplaceAsync(Number);
        Assert.Equal("JOB0009", (await RunAsync(JobMode.Stream)).Placement!.Refusal!.Id);
    }

    [Fact]
    public async Task What_a_typed_line_did_to_the_position_is_kept_and_a_power_cycle_then_is_no_fresh_machine()
    {
        await CutAsync(JobMode.Stream);
        await ActAsync(async machine =>
        {
            await machine.Connection.Terminal.TypeAsync("confirm DPA=7000", _limit.Token);
            await machine.Hand.SetMotorsAsync(on: true, _limit.Token); // looks at once, as the watch does ten times a second
            Assert.Equal(new CountsPoint(7000, 0), machine.Connection.Lease!.Memory.RestPosition);
        });
        await ReplaceAsync(Number);

        Assert.Equal("JOB0009", (await RunAsync(JobMode.Stream)).Placement!.Refusal!.Id);
    }

    [Theory]
    [InlineData("look")]
    [InlineData("move")]
    [InlineData("here")]
    [InlineData("burned")]
    public async Task What_is_done_by_hand_after_a_power_cycle_vouches_for_no_origin(string between)
    {
        for (var i = 0; i < 4; i++) await CutAsync(JobMode.Stream); // The controller's clock is stored at the start of each.
        await CutAsync(JobMode.Stream, options => options with { Finish = FinishPlace.Stay }); // It is at rest away from 0.
        var mark = System.Text.Json.JsonDocument.Parse(await File.ReadAllTextAsync(Directory.GetFiles(_folder.FullName, "*.json").Single())).RootElement.GetProperty("mark").GetInt32();
        await ReplaceAsync(Number);

        if (between is "look" or "burned") await ActAsync(async machine =>
        {
            if (between == "burned") await machine.Connection.Terminal.TypeAsync(string.Create(CultureInfo.InvariantCulture, $"cncmark={mark}"), _limit.Token); // as BV brings it back; the clock started again
            await machine.Hand.SetMotorsAsync(on: true, _limit.Token);
        });
        if (between == "move") await ActAsync(async machine =>
        {
            foreach (var goal in new[] { 500, 0 }) await machine.Hand.GoToAsync(new CountsPoint(goal, 0), Path.Combine(_folder.FullName, $"goto{goal}.jsonl"), feed: null, _limit.Token);
        });
        if (between is "here" or "burned") await CutAsync(JobMode.Stream, options => options with { Origin = new OriginRequest.PresentPosition() });

        Assert.Equal((0L, 0L), Position);
        Assert.Equal("JOB0009", (await RunAsync(JobMode.Stream)).Placement!.Refusal!.Id);
    }

    /// <summary>Motion of a stepper is not detected while its motor is off: an origin cannot be set then, and an earlier one is lost also after the motor is on
    /// again.</summary>
    [Fact]
    public async Task A_stepper_whose_motor_is_off_gets_no_origin_and_loses_the_one_it_had()
    {
        await ActAsync(async machine =>
        {
            await machine.Connection.Terminal.TypeAsync("confirm MO", _limit.Token);
            await machine.Connection.Terminal.TypeAsync("confirm MT 2,2", _limit.Token);
            await machine.Connection.Terminal.TypeAsync("confirm SH", _limit.Token);
        });
        await ActAsync(machine => machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X + 300, here.Position.Y, null), _limit.Token));
        await CutAsync(JobMode.Stream);

        await ActAsync(async machine =>
        {
            await machine.Hand.SetMotorsAsync(on: false, _limit.Token);
            var refused = await machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X, 0, null), _limit.Token);
            Assert.Contains("stepper motors are off and do not hold their position: X, Y. Switch the motors on", refused!.Message, StringComparison.Ordinal);
            await machine.Hand.SetMotorsAsync(on: true, _limit.Token);
            Assert.Equal(Workbench.Machines.MachineState.NoOrigin, machine.Status.State);
        });
        var lost = await RunAsync(JobMode.Stream);
        Assert.Equal("JOB0010", lost.Placement!.Refusal!.Id);
        await ActAsync(machine => machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X, here.Position.Y, null), _limit.Token));
        await CutAsync(JobMode.Stream);
    }

    [Fact]
    public async Task A_controller_that_takes_no_mark_gets_no_origin_that_nobody_could_know_again()
    {
        await ActAsync(async machine =>
        {
            for (var i = 0; i < 254; i++) await machine.Connection.Terminal.TypeAsync(string.Create(CultureInfo.InvariantCulture, $"v{i}=1"), _limit.Token);
            var refused = await Assert.ThrowsAsync<MachineMemoryException>(() => machine.Origins.SetAsync((memory, _) => memory.WithOrigin("G54", 7, 7, null), _limit.Token));
            Assert.Contains("cncmark", refused.Message, StringComparison.Ordinal);
            Assert.Empty(machine.Connection.Lease!.Memory.Origins);
        });
    }

    [Fact]
    public async Task A_machine_that_stands_elsewhere_and_was_never_zeroed_is_refused_and_here_takes_it()
    {
        await ActAsync(machine => machine.Hand.GoToAsync(new CountsPoint(9000, 0), Path.Combine(_folder.FullName, "goto.jsonl"), feed: null, _limit.Token));
        foreach (var file in Directory.GetFiles(_folder.FullName, "*.json")) File.Delete(file);

        Assert.Equal("JOB0008", (await RunAsync(JobMode.Stream)).Placement!.Refusal!.Id);
        var here = await CutAsync(JobMode.Stream, options => options with { Origin = new OriginRequest.PresentPosition() });

        Assert.Contains((9000L, 5000L), here);
        Assert.Equal((9000L, 0L), Position);
        Assert.Equal("JOB0008", (await RunAsync(JobMode.Stream)).Placement!.Refusal!.Id); // A position that was used once is not an origin.
    }

    [Fact]
    public async Task A_second_host_is_told_who_has_the_machine_and_gets_it_when_the_first_lets_go()
    {
        await using (var first = new Workbench.Machines.MachineSession(_clock, _folder.FullName))
        {
            await first.Connection.ConnectAsync(await AddressAsync(), _limit.Token);
            var taken = await RunAsync(JobMode.Stream);
            Assert.Equal((JobOutcome.Refused, 0), (taken.Result.Outcome, taken.Result.SegmentsSent));
            Assert.Contains(string.Create(CultureInfo.InvariantCulture, $"CncEngraver (process {Environment.ProcessId}, since "), taken.Result.Message, StringComparison.Ordinal);
        }

        Assert.Equal(JobOutcome.Complete, (await RunAsync(JobMode.Stream)).Result.Outcome);
    }

    [Fact]
    public async Task A_file_that_is_no_record_or_cannot_be_written_moves_nothing_and_is_left_as_it_is()
    {
        await CutAsync(JobMode.Stream);
        var file = Directory.GetFiles(_folder.FullName, "*.json").Single();
        await File.WriteAllTextAsync(file, "{ \"active\": \"G54\", \"origins\"");
        var rows = _controller.Record.Snapshot().Count;

        var torn = await RunAsync(JobMode.Stream);

        Assert.Equal(JobOutcome.Refused, torn.Result.Outcome);
        Assert.Contains(file, torn.Result.Message, StringComparison.Ordinal);
        Assert.Equal(rows, _controller.Record.Snapshot().Count);
        Assert.Equal("{ \"active\": \"G54\", \"origins\"", await File.ReadAllTextAsync(file));
    }

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    private static Drawing Drawing() => new DrawingBuilder().Line(0, 5, 0, 10).Line(0, 10, 15, 10).Build();

    private (long X, long Y) Position => _controller.Record.Snapshot() is [.., var last] ? (last.A, last.B) : (0, 0);

    private SimulatedController NewController(int number = Number) => new(new SimulatorOptions { Speed = double.PositiveInfinity, Time = _clock, SerialNumber = number });

    /// <summary>The controller is switched off and on, or exchanged: the new one answers at another address, which does not identify it.</summary>
    private async Task ReplaceAsync(int number)
    {
        await _controller.DisposeAsync();
        (_controller, _address) = (NewController(number), null);
    }

    private async Task<ControllerAddress> AddressAsync()
    {
        if (_address is { } known) return known;
        var place = await _controller.ListenTcpAsync(0, _limit.Token);
        var clock = await _controller.ListenClockAsync(_limit.Token);
        Assert.True(ControllerAddress.TryParse(string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}"), out _address));
        return _address!;
    }

    private async Task ActAsync(Func<Workbench.Machines.MachineSession, Task> act)
    {
        await using var machine = new Workbench.Machines.MachineSession(_clock, _folder.FullName);
        await machine.Connection.ConnectAsync(await AddressAsync(), _limit.Token);
        await act(machine);
    }

    private async Task<MachineRunReport> RunAsync(JobMode mode, Func<MachineRunOptions, MachineRunOptions>? with = null, MachineProfile? profile = null, IProgress<JobProgress>? progress = null, CancellationToken stop = default)
    {
        var settings = new DrawingSettings { Machine = profile ?? MachineProfile.Default };
        var job = JobPreparation.Prepare(Drawing(), settings, mode.Strategy().Style);
        var options = new MachineRunOptions(await AddressAsync(), mode.Strategy()) { JournalPath = Path.Combine(_folder.FullName, $"run{++_runs}.jsonl"), Memories = new MachineMemories(_folder.FullName), LeaseOwner = "a test" };
        return await MachineRun.RunAsync(job, job.Motion.Program!, with?.Invoke(options) ?? options, _clock, progress, stop).WaitAsync(_limit.Token);
    }

    /// <summary>Positions with the tool on in this run.</summary>
    private async Task<List<(long, long)>> CutAsync(JobMode mode, Func<MachineRunOptions, MachineRunOptions>? with = null, MachineProfile? profile = null)
    {
        var rows = _controller.Record.Snapshot().Count;
        var report = await RunAsync(mode, with, profile);
        Assert.True(report.Result.Outcome == JobOutcome.Complete, report.Result.Message);
        return [.. _controller.Record.Snapshot().Skip(rows).Where(sample => (sample.Outputs & 1) != 0).Select(sample => ((long)sample.A, (long)sample.B)).Distinct()];
    }

    private async Task StoppedAsync(JobMode mode)
    {
        using var stop = new CancellationTokenSource();
        var report = await RunAsync(mode, progress: new StopOnTool(stop), stop: stop.Token);
        Assert.Equal(JobOutcome.Stopped, report.Result.Outcome);
    }

    private sealed class StopOnTool(CancellationTokenSource stop) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            if (value.ToolOn && value.Y > 6000) stop.Cancel();
        }
    }
}
