using Engraver.Core.Machines;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.Workbench.Tests.Machines;

public class MachineWatchTests
{
    [Fact]
    public async Task A_connected_machine_tells_its_state_without_being_asked()
    {
        await using var bench = await MachineBench.ConnectedAsync();

        var status = bench.Machine.Status;

        Assert.Equal(MachineState.Ready, status.State);
        Assert.StartsWith("DMC2143", status.Controller, StringComparison.Ordinal);
        Assert.Equal(bench.Address, status.Link);
        Assert.False(status.IsSimulation);
        Assert.Equal((0.0, 0.0), (status.MachinePosition!.Value.X, status.MachinePosition.Value.Y));
        Assert.Null(status.WorkPosition);
        Assert.Equal((true, false), (status.MotorsOn!.Value, status.ToolCommanded!.Value));
    }

    [Fact]
    public async Task A_limit_switch_is_seen_while_idle_and_is_one_alarm_however_long_it_stands()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        bench.Controller.SetLimitSwitch(0, forward: true, active: true);
        var status = await bench.UntilAsync(status => status.State == MachineState.Fault);
        await bench.UntilAsync(later => later.Time >= status.Time + TimeSpan.FromSeconds(1));

        Assert.Equal("the forward limit of axis X", status.Limit);
        var alarm = Assert.Single(bench.Machine.Alarms.Open);
        Assert.Equal((AlarmCause.Limit, 1, true), (alarm.Cause, alarm.Count, alarm.IsFirstOut));

        bench.Controller.SetLimitSwitch(0, forward: true, active: false);
        await bench.UntilAsync(status => status.State == MachineState.Ready);
        Assert.Equal(AlarmState.ClearedUnacknowledged, Assert.Single(bench.Machine.Alarms.Open).State);
    }

    [Fact]
    public async Task A_link_that_is_lost_while_idle_is_a_fault_and_an_alarm()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        bench.Controller.DropConnections();

        var status = await bench.UntilAsync(status => status.State == MachineState.Fault);

        Assert.NotEmpty(status.Reason);
        var alarm = Assert.Single(bench.Machine.Alarms.Open);
        Assert.Equal((AlarmCause.LinkLost, AlarmState.Unacknowledged), (alarm.Cause, alarm.State));
        Assert.Contains("CNCCONNECT", alarm.ToDo, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Motors_are_switched_and_seen()
    {
        await using var bench = await MachineBench.ConnectedAsync();

        Assert.Null(await bench.Machine.Hand.SetMotorsAsync(on: false, bench.Limit));
        Assert.Equal(MachineState.MotorsOff, bench.Machine.Status.State);
        Assert.Null(await bench.Machine.Hand.SetMotorsAsync(on: true, bench.Limit));
        Assert.Equal(MachineState.Ready, bench.Machine.Status.State);
    }

    [Fact]
    public async Task Stop_with_no_job_still_stops_what_somebody_else_has_begun()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Connection.Terminal.TypeAsync("SB 1;SPA=1000;PRA=2000000000;BGA", bench.Limit);
        Assert.True(bench.Controller.Status.IsMoving);

        Assert.False(bench.Machine.Controls.Stop());
        var stopped = await bench.Controller.WaitUntilAsync(status => !status.IsMoving && status.Outputs == 0, bench.Limit);

        Assert.True(stopped.IsIdle);
    }

    [Fact]
    public async Task Abort_leaves_the_motors_off()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Connection.Terminal.TypeAsync("SPA=1000;PRA=2000000000;BGA", bench.Limit);

        Assert.True(bench.Machine.Controls.Abort());
        var status = await bench.UntilAsync(status => status.State == MachineState.MotorsOff);

        Assert.False(bench.Controller.Status.IsMoving);
        Assert.False(status.MotorsOn);
    }

    [Fact]
    public async Task A_controller_at_work_for_somebody_else_is_busy()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Connection.Terminal.TypeAsync("SPA=1000;PRA=2000000000;BGA", bench.Limit);

        Assert.Equal(MachineState.Busy, (await bench.UntilAsync(status => status.State != MachineState.Ready)).State);
    }

    [Fact]
    public async Task The_terminal_keeps_what_was_typed_answered_and_withheld()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Connection.Terminal.TypeAsync("MG 1+1", bench.Limit);
        await bench.Machine.Connection.Terminal.TypeAsync("XYZZY", bench.Limit);
        await bench.Machine.Connection.Terminal.TypeAsync("RS", bench.Limit);

        var kinds = bench.Machine.Connection.Terminal.Lines.Select(line => line.Kind).ToList();
        Assert.Equal([null, TerminalAnswerKind.Reply, null, TerminalAnswerKind.Refusal, null, TerminalAnswerKind.Withheld], kinds);
        Assert.Equal("2", bench.Machine.Connection.Terminal.Lines[1].Text.TrimEnd('0', '.').Trim());
        Assert.Contains("1 ", bench.Machine.Status.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public async Task After_disconnecting_the_machine_is_offline_and_the_controller_has_its_handles_back()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Connection.DisconnectAsync();

        Assert.Equal(MachineState.Offline, bench.Machine.Status.State);
        Assert.True((await bench.Controller.WaitUntilAsync(status => status.OpenHandles == 0, bench.Limit)).IsIdle);
        Assert.Equal(TerminalAnswerKind.Withheld, Assert.Single(await bench.Machine.Connection.Terminal.TypeAsync("MG 1", bench.Limit)).Kind);
    }
}
