using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Jobs on a polled machine. Uses the wall clock: a job waits for a controller in real or virtual time.</summary>
public sealed class MachineJobTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-machine-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));

    [Fact]
    public async Task Progress_tells_what_is_engraved_and_where_the_machine_is()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse("sim:"), _limit.Token);
        List<MachineStatus> seen = [];
        machine.Changed += (_, _) => { lock (seen) seen.Add(machine.Status); };
        var report = await RunAsync(machine, MachineBench.Job());

        Assert.Equal(JobOutcome.Complete, report.Result.Outcome);
        lock (seen)
        {
            var running = seen.Where(status => status is { State: MachineState.Running, Progress: not null }).ToList();
            Assert.NotEmpty(running);
            Assert.True(running.Zip(running.Skip(1)).All(pair => pair.First.Progress!.SegmentsDone <= pair.Second.Progress!.SegmentsDone));
            Assert.All(running, status => Assert.Equal(status.Progress!.Position, status.WorkPosition));
            Assert.Contains(running, status => status.ToolCommanded == true);
        }

        var rest = machine.Status;
        Assert.Equal((MachineState.Complete, 1.0, true), (rest.State, rest.Progress!.Fraction, rest.IsSimulation));
        Assert.Equal(rest.WorkPosition, rest.MachinePosition); // The job started at the controller's zero.
        Assert.Empty(machine.Alarms.All);
    }

    [Fact]
    public async Task The_second_job_keeps_machine_and_work_coordinates_apart()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse("sim:"), _limit.Token);
        await RunAsync(machine, MachineBench.Job());
        var first = machine.Status.MachinePosition!.Value;
        await RunAsync(machine, MachineBench.Job());

        var status = machine.Status;
        Assert.Equal(first.X * 2.0, status.MachinePosition!.Value.X, precision: 9);
        Assert.Equal(first.X, status.WorkPosition!.Value.X, precision: 9);
    }

    [Fact]
    public async Task Stop_from_another_thread_stops_at_once_although_the_caller_of_the_job_is_blocked()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(SlowSimulator.Address), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });

        var stopped = false;
        var input = new Thread(() => stopped = machine.Controls.Stop());
        input.Start();
        input.Join();
        Assert.True(stopped);
        Assert.Equal(JobOutcome.Stopped, (await running.WaitAsync(_limit.Token)).Result.Outcome);
        Assert.Equal((MachineState.Stopped, false), (machine.Status.State, machine.Status.ToolCommanded!.Value));
        Assert.Equal((AlarmCause.JobStopped, AlarmState.Unacknowledged), (machine.Alarms.All.Single().Cause, machine.Alarms.All.Single().State));
    }

    [Fact]
    public async Task Stopping_is_told_from_the_press_to_the_standstill()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(SlowSimulator.Address), _limit.Token);
        var slow = new DrawingSettings { Machine = MachineProfile.Default with { AccelerationCounts = 10_240 } }; // It decelerates for a second.
        var running = RunAsync(machine, JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 20, 0).Build(), slow, MotionStyle.Continuous));
        await SeenAsync(machine, status => status is { State: MachineState.Running, WorkPosition.X: > 5.0 });
        var told = SeenAsync(machine, status => status.State == MachineState.Stopping);
        machine.Controls.Stop();
        await told;
        await running.WaitAsync(_limit.Token);

        Assert.Equal(MachineState.Stopped, machine.Status.State);
    }

    [Fact]
    public async Task Abort_in_a_job_ends_it_with_the_motors_off()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(SlowSimulator.Address), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });
        Assert.True(machine.Controls.Abort());

        Assert.NotEqual(JobOutcome.Complete, (await running.WaitAsync(_limit.Token)).Result.Outcome);
        await SeenAsync(machine, status => status.State == MachineState.MotorsOff);
        Assert.False(machine.Status.ToolCommanded);
    }

    /// <summary>Every job opens the line again, and so does the session after it.</summary>
    [Theory]
    [InlineData(SerialDriver.Own)]
    [InlineData(SerialDriver.Ports)]
    public async Task A_serial_line_carries_a_job_a_stop_a_lost_cable_and_the_next_connection(SerialDriver driver)
    {
        await using var controller = new SimulatedController(new SimulatorOptions());
        var line = Path.Combine(_folder.FullName, "tty");
        await controller.ServeSerialAsync(line, 115200, _limit.Token);
        var address = new SerialAddress(line, 115200) { Driver = driver };
        await using var machine = new MachineSession(TimeProvider.System);

        var identity = await machine.Connection.ConnectAsync(address, _limit.Token);
        Assert.Equal(JobOutcome.Complete, (await RunAsync(machine, MachineBench.Job())).Result.Outcome);

        var stopped = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });
        machine.Controls.Stop();
        Assert.Equal(JobOutcome.Stopped, (await stopped.WaitAsync(_limit.Token)).Result.Outcome);
        await SeenAsync(machine, status => status is { State: MachineState.Stopped, ToolCommanded: false });

        await machine.Connection.DisconnectAsync();
        Assert.Equal(identity.Model, (await machine.Connection.ConnectAsync(address, _limit.Token)).Model);
        var cut = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });
        controller.DropConnections();
        Assert.Equal(JobOutcome.LinkLost, (await cut.WaitAsync(_limit.Token)).Result.Outcome);

        Assert.Equal(identity.Model, await ModelAfterTriesAsync(machine, address));
    }

    /// <summary>Connects as an operator does who plugs the cable in again: until the device is there.</summary>
    private async Task<string> ModelAfterTriesAsync(MachineSession machine, SerialAddress address)
    {
        while (true)
        {
            try
            {
                return (await machine.Connection.ConnectAsync(address, _limit.Token)).Model;
            }
            catch (ControllerLinkException) when (!_limit.IsCancellationRequested)
            {
                await Task.Yield(); // the new pseudo-terminal is not there yet
            }
        }
    }

    [Fact]
    public async Task Abort_in_a_job_over_a_serial_line_stops_it_and_leaves_the_motors_on()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        await using var controller = new SimulatedController(new SimulatorOptions());
        var line = Path.Combine(folder.FullName, "tty");
        await controller.ServeSerialAsync(line, 115200, _limit.Token);
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse($"serial://{line}?baud=115200"), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });

        Assert.False(machine.Controls.Abort());

        Assert.Equal(JobOutcome.Stopped, (await running.WaitAsync(_limit.Token)).Result.Outcome);
        await SeenAsync(machine, status => status is { State: MachineState.Stopped, MotorsOn: true, ToolCommanded: false });
        folder.Delete(recursive: true);
    }

    [Fact]
    public async Task A_link_that_is_lost_in_a_job_is_an_alarm_and_what_was_engraved_stays_known()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await controller.ListenTcpAsync(0, _limit.Token);
        var clock = await controller.ListenClockAsync(_limit.Token);
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}")), _limit.Token);
        machine.Changed += (_, _) => { if (machine.Status is { State: MachineState.Running, Progress.SegmentsDone: > 0 }) controller.DropConnections(); };
        var report = await RunAsync(machine, MachineBench.Job());

        Assert.Equal(JobOutcome.LinkLost, report.Result.Outcome);
        var alarm = machine.Alarms.All[0];
        Assert.Equal((AlarmCause.LinkLost, true), (alarm.Cause, alarm.IsFirstOut));
        Assert.Matches("after [12] segments?$", alarm.Where);
        Assert.InRange(machine.Status.Progress!.SegmentsDone, 1, 2);
    }

    [Fact]
    public async Task A_machine_with_an_alarm_starts_again_and_acknowledging_is_not_what_resets_it()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:");
        talk.Session.Machine.Alarms.Raise(AlarmCause.JobStopped, "It stopped.", "there", "Look.");
        await talk.TypeAsync("ALARMS", "?");
        Assert.Contains("1 ", talk.Said, StringComparison.Ordinal);
        Assert.Contains("active, not acknowledged, first alarm: It stopped. (there) Look.", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("ALARMS", "1");
        Assert.Equal(AlarmState.Acknowledged, talk.Session.Machine.Alarms.All.Single().State);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("ALARMS", "1"));

        await talk.TypeAsync("CNCARM", "Stream", "CNCRUN", "ALARMS", "", "ALARMS", "History");
        Assert.Equal(AlarmState.Cleared, talk.Session.Machine.Alarms.All.Single().State);
        Assert.Contains("No alarms.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Leaving_while_a_job_runs_stops_the_machine_first()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        var end = await controller.ListenTcpAsync(0, _limit.Token);
        var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}")), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });

        await machine.DisposeAsync();

        Assert.Equal(JobOutcome.Stopped, (await running.WaitAsync(_limit.Token)).Result.Outcome);
        Assert.Equal((true, 0), (controller.Status.IsIdle, (int)controller.Status.Outputs));
    }

    [Fact]
    public async Task Disconnecting_while_a_job_runs_stops_the_machine_first()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        var end = await controller.ListenTcpAsync(0, _limit.Token);
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}")), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });

        await machine.Connection.DisconnectAsync();

        Assert.Equal(JobOutcome.Stopped, (await running.WaitAsync(_limit.Token)).Result.Outcome);
        Assert.Equal((true, 0), (controller.Status.IsIdle, (int)controller.Status.Outputs));
        Assert.Equal((null, MachineState.Offline), (machine.Connection.Description, machine.Status.State));
    }

    [Fact]
    public async Task While_a_job_runs_no_other_motion_begins_and_the_job_goes_on()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(SlowSimulator.Address), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });
        var journal = Path.Combine(_folder.FullName, "hand.jsonl");

        await Assert.ThrowsAsync<InvalidOperationException>(() => RunAsync(machine, MachineBench.Job()));
        await Assert.ThrowsAsync<InvalidOperationException>(() => machine.Hand.GoToAsync(default, journal, null, _limit.Token));
        await Assert.ThrowsAsync<InvalidOperationException>(() => machine.Hand.StepAsync(default, false, journal, null, _limit.Token));
        await Assert.ThrowsAsync<InvalidOperationException>(() => machine.Hand.SetMotorsAsync(false, _limit.Token));
        await Assert.ThrowsAsync<InvalidOperationException>(() => machine.Connection.ConnectAsync(ControllerAddress.Parse("sim:"), _limit.Token));
        Assert.Equal(MachineState.Running, machine.Status.State);
        machine.Controls.Stop();

        Assert.Equal(JobOutcome.Stopped, (await running.WaitAsync(_limit.Token)).Result.Outcome);
    }

    [Fact]
    public async Task A_terminal_line_typed_while_a_job_runs_is_withheld()
    {
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(SlowSimulator.Address), _limit.Token);
        var running = RunAsync(machine, MachineBench.Job());
        await SeenAsync(machine, status => status is { State: MachineState.Running, ToolCommanded: true });
        var answer = Assert.Single(await machine.Connection.Terminal.TypeAsync("MG 1", _limit.Token));
        machine.Controls.Stop();
        await running.WaitAsync(_limit.Token);

        Assert.Contains("A job is running", answer.Text, StringComparison.Ordinal);
    }

    public void Dispose()
    {
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    private Task<MachineRunReport> RunAsync(MachineSession machine, PreparedJob job) => machine.Runs.RunAsync(
        job, job.Motion.Program!, address => new MachineRunOptions(address, JobMode.Stream.Strategy()) { JournalPath = Path.Combine(_folder.FullName, $"{Guid.NewGuid():N}.jsonl") }, CancellationToken.None);

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
