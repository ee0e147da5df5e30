using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs;
using Engraver.Galil.Programs.Resident;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Execution;

/// <summary>Homing on the simulated controller, whose switches and index pulses are at known counts from the position at power-on.</summary>
public class HomingMoveTests
{
    private static readonly AxisSwitches s_lineA = new(0) { HomeAt = -20000, IsHomeBelow = true, ReverseLimitAt = -24000, ForwardLimitAt = 90000, IndexAt = -19300, IndexPeriod = 4000 };
    private static readonly AxisSwitches s_lineB = new(1) { HomeAt = 15000, ForwardLimitAt = 18000, ReverseLimitAt = -70000, IndexAt = 14600, IndexPeriod = 4000 };

    [Theory]
    [InlineData(HomingMark.Switch, -20000)]
    [InlineData(HomingMark.Limit, -24000)]
    [InlineData(HomingMark.SwitchIndex, -19300)]
    [InlineData(HomingMark.LimitIndex, -23300)]
    [InlineData(HomingMark.Index, -3300)]
    public async Task The_mark_gets_its_machine_position_and_the_axis_backs_off(HomingMark mark, int at)
    {
        await using var bench = new SimulatedBench(switches: [s_lineA]);
        var before = await FingerprintAsync(bench);

        var homed = await HomeAsync(bench, Profile(new AxisHoming { By = mark, Zero = 5, BackOff = 2 }));

        Assert.Equal((JobOutcome.Complete, "The machine is homed."), (homed.Result.Outcome, homed.Result.Message));
        Assert.Equal(new CountsPoint(7000, 0), homed.Result.FinalPosition); // 5 mm, and 2 mm back
        Assert.InRange(homed.Shift![0], 5000 - at - 3, 5000 - at + 3); // the edge is detected within two program lines at 1000 counts/s
        Assert.Equal(0, homed.Shift[1]);
        Assert.Equal(before, await FingerprintAsync(bench));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-26)]
    [InlineData(12)]
    public async Task The_same_place_is_found_wherever_the_machine_stood(double start)
    {
        await using var bench = new SimulatedBench(switches: [s_lineA with { ReverseLimitAt = -40000 }]);
        await using var session = await bench.OpenAsync();
        var profile = Profile(new AxisHoming { By = HomingMark.Switch });
        if (start != 0.0) await JobRunner.GoToAsync(new MotionProgram(profile, default, []), new CountsPoint((int)(start * 1000), 0), session, SimulatedBench.Job, null, CancellationToken.None);

        var homed = await JobRunner.HomeAsync(new MotionProgram(profile, default, []), session, SimulatedBench.Job, null, CancellationToken.None);
        var again = await JobRunner.HomeAsync(new MotionProgram(profile, default, []), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.InRange(homed.Shift![0], 19997, 20003);
        Assert.InRange(again.Shift![0], -2, 2);
    }

    [Fact]
    public async Task Axes_are_homed_in_their_order_each_in_its_direction_and_a_mirrored_axis_by_the_machines_millimetres()
    {
        await using var bench = new SimulatedBench(switches: [s_lineA, s_lineB]);
        var axes = new MachineAxes(
            new MachineAxis('A', 1000) { Homing = new AxisHoming { Order = 1 } },
            new MachineAxis('B', -1000) { Homing = new AxisHoming { Order = 0, Zero = 3, BackOff = 1 } }); // minus of the mirrored axis is forward

        var homed = await HomeAsync(bench, MachineProfile.Default with { Axes = axes });

        Assert.Equal(new CountsPoint(2000, -4000), homed.Result.FinalPosition);
        Assert.InRange(homed.Shift![1], -18003, -17997);
        var rows = bench.Controller.Record.Snapshot();
        Assert.True(rows.First(row => row.A != 0).Sample > rows.Last(row => row.A == 0).Sample);
        Assert.True(rows.Where(row => row.A == 0).Max(row => row.B) >= 15000);
    }

    [Theory]
    [InlineData("none", "was not homed within")]
    [InlineData("limit", "stopped before it reached its homing reference (home switch): ")]
    [InlineData("short", "overran its homing reference (home switch)")]
    [InlineData("stepper", "stepper")]
    [InlineData("motor", "motor")]
    public async Task What_cannot_be_homed_ends_with_a_sentence_and_a_machine_at_rest(string fault, string sentence)
    {
        await using var bench = new SimulatedBench(switches: fault switch
        {
            "none" => [],
            "limit" => [s_lineA with { HomeAt = null }],
            "short" => [s_lineA with { HomeReach = 50 }],
            _ => [s_lineA],
        });
        if (fault == "stepper") await bench.SendAsync("MOA", "MTA=2", "SHA");
        if (fault == "motor") await bench.SendAsync("MOA");

        var homed = await HomeAsync(bench, Profile(new AxisHoming { By = fault == "stepper" ? HomingMark.Index : HomingMark.Switch, Seconds = 10 }));

        Assert.Equal(JobOutcome.Refused, homed.Result.Outcome);
        Assert.Contains(sentence, homed.Result.Message, StringComparison.Ordinal);
        Assert.Null(homed.Shift);
        Assert.True(bench.Controller.Status.IsIdle);
    }

    [Fact]
    public async Task A_stop_in_the_middle_stops_it_and_leaves_the_controller_as_it_was_found()
    {
        await using var bench = new SimulatedBench(switches: [s_lineA]);
        var before = await FingerprintAsync(bench);
        using var stop = new CancellationTokenSource();

        var homed = await HomeAsync(bench, Profile(new AxisHoming()), new CancelWhen(progress => progress.X < -5000, stop.Cancel), stop.Token);

        Assert.Equal((JobOutcome.Stopped, true), (homed.Result.Outcome, homed.Shift is null));
        Assert.InRange(bench.Last.A, -8000, -5000);
        Assert.Equal(before, await FingerprintAsync(bench));
    }

    [Fact]
    public async Task A_dead_host_in_the_middle_is_found_by_the_watchdog_in_the_controller()
    {
        await using var bench = new SimulatedBench(switches: [s_lineA with { HomeAt = -200000, ReverseLimitAt = null }]);
        var cutAt = 0L;

        var homed = await HomeAsync(bench, Profile(new AxisHoming()), new CancelWhen(progress => progress.X < -5000, () =>
        {
            cutAt = bench.Controller.Status.Sample;
            bench.Controller.DropConnections();
        }));
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));

        Assert.Equal(JobOutcome.LinkLost, homed.Result.Outcome);
        CutRecord.AssertSafeAfter(bench, cutAt, toolSeconds: 1.5, restSeconds: 1.5);
    }

    [Fact]
    public async Task Soft_limits_of_the_zero_before_do_not_stand_in_its_way_and_are_there_again_afterwards()
    {
        await using var bench = new SimulatedBench(switches: [s_lineA]);
        await bench.SendAsync("BLA=-1000", "FLA=1000");

        var homed = await HomeAsync(bench, Profile(new AxisHoming()));

        Assert.Equal(JobOutcome.Complete, homed.Result.Outcome);
        Assert.Equal(["-1000", "1000"], [await bench.WholeAsync("_BLA"), await bench.WholeAsync("_FLA")]);
    }

    [Fact]
    public void Every_line_of_the_program_fits_the_controller_and_every_jump_has_its_label()
    {
        var axes = new MachineAxes(new MachineAxis('A', 1000) { Homing = new AxisHoming { By = HomingMark.SwitchIndex } }, new MachineAxis('B', -1000) { Homing = new AxisHoming { By = HomingMark.LimitIndex, Order = 1 } });
        var program = ResidentProgram.ForHoming(MachineProfile.Default with { Axes = axes });

        var jumps = System.Text.RegularExpressions.Regex.Matches(program.Text, "J[PS](#[A-Z0-9]+)").Select(jump => jump.Groups[1].Value);
        Assert.Empty(jumps.Except(program.Labels));
        Assert.All(program.Labels, label => Assert.InRange(label.Length, 2, 8));
        Assert.Equal(program.Labels.Count, program.Labels.Distinct().Count());
    }

    private static MachineProfile Profile(AxisHoming homing) => MachineProfile.Default with { Axes = MachineProfile.Default.Axes with { X = MachineProfile.Default.Axes.X with { Homing = homing } } };

    private static async Task<HomingResult> HomeAsync(SimulatedBench bench, MachineProfile profile, IProgress<JobProgress>? progress = null, CancellationToken stop = default)
    {
        await using var session = await bench.OpenAsync();
        return await JobRunner.HomeAsync(new MotionProgram(profile, default, []), session, SimulatedBench.Job, progress, stop);
    }

    private static async Task<string> FingerprintAsync(SimulatedBench bench)
    {
        var text = await bench.FingerprintAsync();
        foreach (var operand in new[] { "_FLA", "_BLA", "_FLB", "_BLB" }) text += $"\n{operand} {await bench.WholeAsync(operand)}";
        return text;
    }
}
