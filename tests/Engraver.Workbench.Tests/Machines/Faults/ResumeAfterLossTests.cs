using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Simulator;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Stopped runs after which the machine position is unknown: its steppers were off and moved by hand, or the power failed. With the origin set again,
/// or after homing, the rest is cut at the position of the work, and not before.</summary>
public sealed class ResumeAfterLossTests : IDisposable
{
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));

    public static TheoryData<JobMode, bool> Remedies => new()
    {
        { JobMode.Stream, false },
        { JobMode.Calls, false },
        { JobMode.Program, false },
        { JobMode.Stream, true },
        { JobMode.Calls, true },
        { JobMode.Program, true },
    };

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    /// <summary>The counts of a motor without current stay while its shaft is turned: which is equivalent to a redefinition of the position (DP).</summary>
    [Theory]
    [MemberData(nameof(Remedies))]
    public async Task Steppers_that_were_off_and_moved_are_homed_or_their_origin_is_set_anew_and_the_rest_is_cut(JobMode mode, bool isHomed)
    {
        await using var machine = new FaultyMachine(MachineKind.Stepper, isHomed);
        await machine.BurnAsync(_limit.Token);
        if (isHomed) Assert.True((await machine.HomeAsync(_limit.Token)).IsComplete);
        await machine.SetOriginAsync(isHomed ? 30_000 : 0, isHomed ? 12_000 : 0, _limit.Token);
        var zero = Zero(machine, isHomed);
        var since = machine.Rows;
        var stopped = await StopAsync(machine, mode);
        await machine.SendAsync(_limit.Token, "MO AB", "DP 4321,-1234");

        var refused = await machine.RunAsync(mode, watched: null, _limit.Token, since, stopped.Journal);
        Assert.Equal("", await machine.SwitchMotorsOnAsync(_limit.Token));
        var poweredOnly = await machine.RunAsync(mode, watched: null, _limit.Token, since, stopped.Journal);
        if (isHomed) Assert.True((await machine.HomeAsync(_limit.Token)).IsComplete);
        else await machine.SetOriginAnewAsync(_limit.Token);
        var rest = await machine.RunAsync(mode, watched: null, _limit.Token, since, stopped.Journal);

        Assert.Equal((JobOutcome.Refused, "JOB0010"), (refused.Result?.Outcome, refused.Refusal));
        Assert.Equal((JobOutcome.Refused, isHomed ? "JOB0031" : "JOB0010"), (poweredOnly.Result?.Outcome, poweredOnly.Refusal));
        Assert.True(rest.IsComplete && rest.IsCutRight, rest.ToString());
        Assert.InRange(Math.Abs(rest.Zero!.Value.X - zero.X) + Math.Abs(rest.Zero.Value.Y - zero.Y), 0, isHomed ? 5 : 0);
        Assert.InRange(rest.CutCounts, 60_000.0, 65_000.0 + (1_000.0 * FaultyMachine.LeadIn) + 1_200.0);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Behind_a_power_cycle_the_origin_is_set_anew_and_the_rest_is_cut(JobMode mode)
    {
        await using var machine = new FaultyMachine(MachineKind.Pen, hasHoming: false);
        await machine.SetOriginAsync(0, 0, _limit.Token);
        var since = machine.Rows;
        var stopped = await StopAsync(machine, mode);
        machine.Inject(new ScheduledFault { Kind = FaultKind.PowerCycle, AtSeconds = 0.0 });

        var refused = await machine.RunAsync(mode, watched: null, _limit.Token, since, stopped.Journal);
        await machine.SetOriginAnewAsync(_limit.Token);
        var rest = await machine.RunAsync(mode, watched: null, _limit.Token, since, stopped.Journal);

        Assert.Equal((JobOutcome.Refused, "JOB0009"), (refused.Result?.Outcome, refused.Refusal));
        Assert.True(rest.IsComplete && rest.IsCutRight && rest.Zero == default(CountsPoint), rest.ToString());
    }

    /// <summary>The link is lost with the power, and the stop reaches the controller after its zero has changed: without a set origin the position would be
    /// taken for the earlier one.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_power_cycle_in_the_middle_of_a_run_is_told_and_its_new_zero_is_no_origin(JobMode mode)
    {
        await using var machine = new FaultyMachine(MachineKind.Pen, hasHoming: false);
        var operators = default(FaultOperator);
        var cut = new FaultCase(0, MachineKind.Pen, HostActivity.LeadIn, mode, new ScheduledFault { Kind = FaultKind.PowerCycle, AtSeconds = 0.5 }, 1);

        var lost = await machine.RunAsync(mode, stop => operators = new FaultOperator(machine, cut, stop), _limit.Token);
        machine.Rest();
        var next = await machine.RunAsync(mode, watched: null, _limit.Token);

        Assert.Equal(JobOutcome.LinkLost, lost.Result?.Outcome);
        Assert.Contains(next.Refusal, (string[])["JOB0009", "JOB0010"]);
        Assert.Contains(string.Create(CultureInfo.InvariantCulture, $"{next.Result!.Outcome}"), "Refused", StringComparison.Ordinal);
    }

    /// <summary>A pen on a third axis that is lifted manually, over the whole sequence of journals.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_run_stopped_with_its_pen_raised_is_resumed_at_the_height_of_the_cut(JobMode mode)
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) } };
        await using var machine = new FaultyMachine(profile, MachineKind.Pen);
        await machine.SetOriginAsync(0, 0, _limit.Token);
        var since = machine.Rows;
        var raised = await machine.RunAsync(mode, stop => new FaultOperator(machine, new FaultCase(1, MachineKind.Pen, HostActivity.Away, mode, new ScheduledFault { Kind = FaultKind.Reset, AtSeconds = 1e6 }, 3) { Step = new CountsPoint(0, 0, 2_400), IsStoppedAway = true }, stop), _limit.Token);
        Assert.Equal((JobOutcome.Stopped, 2_400), (raised.Result?.Outcome, machine.Controller.MotorPlace(2)));

        var rest = await machine.RunAsync(mode, watched: null, _limit.Token, since, raised.Journal);

        Assert.True(rest.IsComplete && rest.IsCutRight, rest.ToString());
        Assert.All(machine.Controller.Record.Snapshot().Skip(since).Where(sample => (sample.Outputs & 1) != 0), sample => Assert.Equal(0, sample.C));
    }

    public void Dispose() => _limit.Dispose();

    private static CountsPoint Zero(FaultyMachine machine, bool isHomed) => new(machine.Controller.PlaceOf(0, isHomed ? 30_000 : 0), machine.Controller.PlaceOf(1, isHomed ? 12_000 : 0));

    private async Task<FaultyRun> StopAsync(FaultyMachine machine, JobMode mode)
    {
        var stopped = await machine.RunAsync(mode, stop => new FaultOperator(machine, new FaultCase(0, MachineKind.Pen, HostActivity.Stop, mode, new ScheduledFault { Kind = FaultKind.Reset, AtSeconds = 1e6 }, 3), stop), _limit.Token);
        Assert.Equal(JobOutcome.Stopped, stopped.Result?.Outcome);
        return stopped;
    }
}
