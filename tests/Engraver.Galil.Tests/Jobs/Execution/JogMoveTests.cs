using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs.Execution;

/// <summary>A jog on the simulated controller, judged by the record of its motors.</summary>
public class JogMoveTests
{
    private static readonly MachineProfile s_profile = MachineProfile.Default;
    private static readonly MotionProgram s_program = new(s_profile, default, []);

    [Theory]
    [InlineData(600, 0)]
    [InlineData(-600, 300)]
    public async Task It_moves_while_it_is_held_and_brakes_when_it_is_released(double x, double y)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("FLA=900000", "BLB=-800000", "JGA=4000");
        var before = await FingerprintAsync(bench);
        var control = new JogControl(new JogVelocity(x, y));
        var far = new CancelWhen(progress => Math.Abs(progress.X) > 20000, control.Release);

        await using (var session = await bench.OpenAsync())
        {
            var result = await JobRunner.JogAsync(s_program, control, session, SimulatedBench.Job, far, CancellationToken.None);

            Assert.Equal((JobOutcome.Complete, "The machine is at rest."), (result.Outcome, result.Message));
            Assert.Equal(new CountsPoint(bench.Last.A, bench.Last.B), result.FinalPosition);
            Assert.Empty(result.NotRestored);
        }

        Assert.InRange(Math.Abs(bench.Last.A), 20000, 22000);
        Assert.Equal(y / x, (double)bench.Last.B / bench.Last.A, 2);
        Assert.Equal(before, await FingerprintAsync(bench));
    }

    [Fact]
    public async Task Its_speed_follows_the_hand_and_its_direction_does_not()
    {
        await using var bench = new SimulatedBench();
        var control = new JogControl(new JogVelocity(600, 0));
        var told = new CancelWhen(progress => progress.X > 5000, () => control.Velocity = new JogVelocity(3000, 0));
        var far = new CancelWhen(progress => progress.X > 100000, control.Release);
        await using var session = await bench.OpenAsync();

        await JobRunner.JogAsync(s_program, control, session, SimulatedBench.Job, new ProgressPair(told, far), CancellationToken.None);

        var rows = bench.Controller.Record.Snapshot();
        double Speed(int at) => rows.Zip(rows.Skip(1)).First(pair => pair.First.A >= at) is var (one, two) ? (two.A - one.A) / (two.Seconds - one.Seconds) : 0;
        Assert.Equal(10000, Speed(4000), 1000.0);
        Assert.Equal(50000, Speed(90000), 1500.0);
    }

    [Fact]
    public async Task A_dead_host_is_braked_a_quarter_of_a_second_after_its_last_sign()
    {
        await using var bench = new SimulatedBench();
        var lastSign = 0L;
        var control = new JogControl(new JogVelocity(3000, 0));
        var dies = new CancelWhen(progress => progress.X > 30000, () =>
        {
            bench.Controller.DropConnections();
            bench.ReleaseClock();
        });
        var session = await bench.OpenAsync(link => link.Sending = line =>
        {
            if (line.StartsWith("hb=", StringComparison.Ordinal)) lastSign = bench.Controller.Status.Sample;
        });
        var jogging = JobRunner.JogAsync(s_program, control, session, SimulatedBench.Job, dies, CancellationToken.None);
        Assert.Equal(JobOutcome.LinkLost, (await jogging).Outcome);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(5));

        var rows = bench.Controller.Record.Snapshot().Where(row => row.Sample > lastSign).ToList();
        var brakes = rows.Zip(rows.Skip(1)).First(pair => pair.Second.A - pair.First.A < 49);
        Assert.InRange(brakes.First.Sample - lastSign, 150, 270);
        Assert.InRange(rows[^1].Sample - brakes.First.Sample, 1, 210); // 50000 / 256000 s
        Assert.Equal((false, (byte)0), (bench.Controller.Status.IsMoving, bench.Controller.Status.Outputs));
    }

    [Theory]
    [InlineData(60)]
    [InlineData(400)]
    public async Task A_slow_link_ends_it_with_a_sentence(int milliseconds)
    {
        await using var bench = new SimulatedBench();
        var isSlow = false;
        var control = new JogControl(new JogVelocity(600, 0));
        var slows = new CancelWhen(progress => progress.X > 5000, () => isSlow = true);
        var session = await bench.OpenAsync(link => link.Sending = _ =>
        {
            if (isSlow) bench.Controller.Advance(TimeSpan.FromMilliseconds(milliseconds));
        });

        var result = await JobRunner.JogAsync(s_program, control, session, SimulatedBench.Job, slows, CancellationToken.None);

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.Contains("The link is too slow", result.Message, StringComparison.Ordinal);
        Assert.False(bench.Controller.Status.IsMoving);
        Assert.Equal(bench.Last.A, result.FinalPosition!.Value.X);
    }

    [Theory]
    [InlineData(3000, 0, 40000, 0)]
    [InlineData(-3000, 3000, -7000, 12000)]
    [InlineData(0, -600, 0, -4001)]
    public async Task It_stops_at_the_end_of_the_travel_and_not_behind_it(double x, double y, int endX, int endY)
    {
        await using var bench = new SimulatedBench();
        SoftLimit[] limits = [new('A', -7000, 40000), new('B', -4001, 12000)];
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(x, y)), session, SimulatedBench.Job with { SoftLimits = limits }, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, new CountsPoint(endX, endY)), (result.Outcome, result.FinalPosition));
        Assert.All(bench.Controller.Record.Snapshot(), row => Assert.True(row.A is >= -7000 and <= 40000 && row.B is >= -4001 and <= 12000));
        Assert.Equal(["2147483647", "-2147483648"], [await bench.WholeAsync("_FLA"), await bench.WholeAsync("_BLA")]);
        var again = await JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(x, y)), session, SimulatedBench.Job with { SoftLimits = limits }, null, CancellationToken.None);
        Assert.Equal((JobOutcome.Refused, "The machine is at the end of its travel. Jog in the other direction."), (again.Outcome, again.Message));
    }

    [Fact]
    public async Task When_one_axis_is_stopped_by_its_switch_the_other_does_not_go_on()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var hit = new CancelWhen(progress => progress.X > 5000, () => bench.Controller.SetLimitSwitch(axis: 0, forward: true, active: true));

        var result = await JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(900, -900)), session, SimulatedBench.Job, hit, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("limit", result.Message, StringComparison.Ordinal);
        Assert.InRange(-bench.Last.B, 5000, 9000); // it stopped before the key was released
    }

    [Fact]
    public async Task Behind_its_travel_it_only_goes_back()
    {
        await using var bench = new SimulatedBench();
        SoftLimit[] limits = [new('A', 1000, 5000)];
        await using var session = await bench.OpenAsync();
        Task<JobResult> Jog(double x) => JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(x, 0)), session, SimulatedBench.Job with { SoftLimits = limits }, null, CancellationToken.None);

        Assert.Contains("Jog it in the other direction", (await Jog(-600)).Message, StringComparison.Ordinal);
        Assert.Equal(new CountsPoint(5000, 0), (await Jog(600)).FinalPosition);
    }

    [Fact]
    public async Task A_limit_switch_ends_it_and_says_so_whichever_axis_it_is()
    {
        await using var bench = new SimulatedBench();
        var hits = new CancelWhen(progress => progress.Y > 5000, () => bench.Controller.SetLimitSwitch(1, forward: true, active: true));
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(0, 600)), session, SimulatedBench.Job, hits, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("forward limit switch", result.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task With_a_motor_off_nothing_moves()
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("MOB");
        await using var session = await bench.OpenAsync();

        var result = await JobRunner.JogAsync(s_program, new JogControl(new JogVelocity(600, 0)), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("Motors off: Y.", result.Message, StringComparison.Ordinal);
        Assert.Equal(0, bench.Controller.Record.Count);
    }

    [Theory]
    [InlineData(19200, JobOutcome.Complete)]
    [InlineData(9600, JobOutcome.Complete)]
    [InlineData(1200, JobOutcome.Refused)]
    public async Task On_a_serial_line_it_holds_as_long_as_the_line_carries_its_signs(int baud, JobOutcome outcome)
    {
        await using var bench = new SimulatedBench();
        var control = new JogControl(new JogVelocity(300, 0));
        var far = new CancelWhen(progress => progress.X > 20000, control.Release);
        await using var session = await bench.OpenSerialAsync(baud);

        var result = await JobRunner.JogAsync(s_program, control, session, SimulatedBench.Job, far, CancellationToken.None);

        Assert.Equal(outcome, result.Outcome);
        if (outcome == JobOutcome.Complete) Assert.InRange(bench.Last.A, 20000, 22500);
        else Assert.Equal(0, bench.Controller.Record.Count);
    }

    private static async Task<string> FingerprintAsync(SimulatedBench bench)
    {
        var text = await bench.FingerprintAsync();
        foreach (var operand in new[] { "_FLA", "_BLA", "_FLB", "_BLB" }) text += $"\n{operand} {await bench.WholeAsync(operand)}";
        return text;
    }
}
