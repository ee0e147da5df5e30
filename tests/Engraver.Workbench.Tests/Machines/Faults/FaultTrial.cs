using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>One case of the matrix on a separate machine: preparation, the activity with its fault, and the following hosts.</summary>
internal sealed class FaultTrial(FaultCase one, CancellationTokenSource limit) : IAsyncDisposable
{
    /// <summary>Counts of a whole part: its drawn length is 64.1 mm, with a tolerance of a tenth for settling.</summary>
    private const double PartCounts = 65_000.0;

    /// <summary>Counts that a resumed run may cut again: its lead-in, and at the planned feed what was cut in 60 ms since the last poll.</summary>
    private const double AgainCounts = (FaultyMachine.LeadIn * 1_000.0) + (20.0 * 60.0);

    /// <summary>Counts from the planned feed to rest, which a tool axis cuts additionally.</summary>
    private const double BrakingCounts = 20.0 * 20.0 * 1_000.0 / 512.0;

    /// <summary>Samples for which a tool may be on while nothing moves: settling, a few polls, and the second until the watchdog trips where a host falls
    /// silent, or as long as the late answers of a case keep it waiting.</summary>
    private const long MostBurn = 2_500;

    /// <summary>Repeatability of a switch, counts.</summary>
    private const int HomingTolerance = 5;

    /// <summary>Position error of a motor at rest that is not reported, counts: 0.2 mm.</summary>
    private const int MostError = 200;

    /// <summary>4 mm of these machines, and what an axis moves until the controller has ended it, mm.</summary>
    private const double JammedMm = 5.0;

    private static readonly CountsPoint s_goal = new(20_000, -7_000);

    private readonly FaultyMachine _machine = new(one.Machine, one.Activity == HostActivity.Home);
    private readonly List<string> _faults = [];
    private CountsPoint _zero;
    private int _since;
    private int _resumes;
    private string _journal = "";

    /// <summary>A switch, an input or a shaft that remains blocked: it affects the next run again.</summary>
    private bool IsStanding => one.Fault is { Kind: FaultKind.LimitSwitch or FaultKind.AbortInput or FaultKind.Jam, ForSeconds: null };

    /// <summary>Lost steps of a jammed stepper are not detected: the machine continues with an offset until it is homed or the origin is set again, and the
    /// part is spoiled.</summary>
    private bool MayLoseSteps => one is { Machine: MachineKind.Stepper, Fault.Kind: FaultKind.Jam };

    /// <summary>A tool axis that is jammed for a short time while the others are at rest cuts nothing wrong.</summary>
    private bool IsOfHeight => one.Fault is { Kind: FaultKind.Jam, Axis: "C" };

    /// <summary>Maximum cut length of all runs of the case, counts.</summary>
    private double MostCounts => PartCounts + (_resumes * AgainCounts) + (_machine.HasHeight ? (_resumes + 1) * BrakingCounts : 0.0);

    public static async Task<ActivityExtent> MeasureAsync(HostActivity activity, JobMode mode, MachineKind machine)
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await using var trial = new FaultTrial(new FaultCase(0, machine, activity, mode, new ScheduledFault { Kind = FaultKind.Reset, AtSeconds = 1e6 }, 4), limit);
        await trial.PrepareAsync();
        var (seconds, bytes, segments) = (trial._machine.Seconds, trial._machine.Controller.BytesArrived, trial._machine.Controller.Status.SegmentsExecuted);
        var run = await trial.RunActivityAsync();
        Assert.True(run.IsComplete, run.ToString());
        return new ActivityExtent(trial._machine.Seconds - seconds, trial._machine.Controller.BytesArrived - bytes, (int)(trial._machine.Controller.Status.SegmentsExecuted - segments));
    }

    /// <returns>The outcome reported by the host, and the errors.</returns>
    public async Task<(string Outcome, IReadOnlyList<string> Faults)> TryAsync()
    {
        await PrepareAsync();
        if (!one.IsOfPart) _machine.Inject(one.Fault);
        var run = await RunActivityAsync();
        Judge(run);
        var state = await StateAsync(run);
        await NextAsync(run);
        return ($"{run.Result?.Outcome.ToString() ?? "unconnected"} {state}", _faults);
    }

    public ValueTask DisposeAsync() => _machine.DisposeAsync();

    private void Check(bool holds, string what, FaultyRun run)
    {
        if (!holds) _faults.Add($"{what}: {run}");
    }

    /// <summary>Preparation without a fault: homing, an origin, a stopped run.</summary>
    private async Task PrepareAsync()
    {
        await _machine.BurnAsync(limit.Token);
        Assert.NotNull(await _machine.PollAsync(limit.Token));
        if (one.Activity == HostActivity.Home)
        {
            var homed = await _machine.HomeAsync(limit.Token);
            Assert.True(homed.IsComplete, homed.ToString());
            _machine.PutWorkAt(4_000);
            await _machine.SetOriginAsync(30_000, 12_000, limit.Token);
            _zero = new CountsPoint(_machine.Controller.PlaceOf(0, 30_000), _machine.Controller.PlaceOf(1, 12_000));
            var away = await _machine.GoToAsync(new CountsPoint(11_000, 9_000), limit.Token);
            Assert.True(away.IsComplete, away.ToString());
        }

        if (one.Activity is HostActivity.GoTo or HostActivity.Jog) await _machine.SetOriginAsync(0, 0, limit.Token); // Otherwise any zero of the controller would be accepted.

        _since = _machine.Rows;
        if (one.IsResumed)
        {
            var stopped = await _machine.RunAsync(one.Mode, stop => new FaultOperator(_machine, one with { Activity = HostActivity.Stop }, stop), limit.Token);
            Assert.True(stopped.Result is { Outcome: JobOutcome.Stopped or JobOutcome.Complete }, stopped.ToString());
            _journal = stopped.Journal;
            Assert.NotNull(await _machine.PollAsync(limit.Token)); // which shows its end
        }
    }

    private Task<FaultyRun> RunActivityAsync() => one.Activity switch
    {
        HostActivity.GoTo => _machine.GoToAsync(s_goal, limit.Token),
        HostActivity.Jog => _machine.JogAsync(new JogVelocity(900, -300), far: 15_000, limit.Token),
        HostActivity.Home => _machine.HomeAsync(limit.Token),
        HostActivity.LeadIn or HostActivity.Resume => ResumeAsync(Watched),
        _ => _machine.RunAsync(one.Mode, Watched, limit.Token),
    };

    private FaultOperator Watched(CancellationTokenSource stop) => new(_machine, one, stop);

    /// <summary>Resumes the interrupted run.</summary>
    private Task<FaultyRun> ResumeAsync(Func<CancellationTokenSource, FaultOperator>? watched)
    {
        _resumes++;
        return _machine.RunAsync(one.Mode, watched, limit.Token, _since, _journal);
    }

    private void Judge(FaultyRun run)
    {
        Check(!limit.IsCancellationRequested, "it hung", run);
        Check(run.Sentence.Length > 0 && !run.Sentence.Contains("Exception", StringComparison.Ordinal), "it is not told in a sentence", run);
        Check(!one.IsRun || !run.IsComplete || MayLoseSteps || run.IsCutRightWithin(IsOfHeight ? JammedMm : FaultyRun.HealthyFollowingMm), "complete and wrong", run);
        Check(!one.IsRun || !run.IsComplete || MayLoseSteps || run.Zero == _zero, "complete and at another place", run);
        Check(!one.IsRun || run.Result?.FrameOrigin is null || run.OpenLoop == (one.Machine == MachineKind.Stepper ? "XY" : ""), $"it takes the positions of {run.OpenLoop} for those that were commanded", run);
        Check(one.Activity != HostActivity.GoTo || !run.IsComplete || MayLoseSteps || IsAt(s_goal), $"complete and at {_machine.Controller.MotorPlace(0)}, {_machine.Controller.MotorPlace(1)}", run);
        Check(run.Result is null || _resumes > 0 || run.Result.SegmentsExecuted <= _machine.Controller.Status.SegmentsExecuted, "it counts segments that were not executed", run);
        Check(run.CutCounts <= MostCounts, "something was cut twice", run);
        Check(run.LongestBurn <= MostBurn, "the tool was on at a standstill", run);
        Check(!one.IsRun || IsOfMotion || run.Record.MaxDeviationMm is not > FaultyMachine.MostBesideMm, "it cut beside the drawing", run);
        var rest = _machine.Rest();
        Check(!rest.IsMoving && (rest.Outputs & 5) == 0, $"outputs {rest.Outputs}, or the machine moves", run);
    }

    /// <summary>True for a fault of the motion, not of the communication.</summary>
    private bool IsOfMotion => one.Fault.Kind is FaultKind.LimitSwitch or FaultKind.AbortInput or FaultKind.MotorOff or FaultKind.Jam or FaultKind.PowerCycle;

    /// <summary>Compares the reported state of the machine at rest with the fault.</summary>
    private async Task<string> StateAsync(FaultyRun run)
    {
        var told = ExpectedReport.Mismatch(one, run);
        Check(told.Length == 0, told, run);
        Check(!one.IsRun || run.Result?.FrameOrigin is null || _machine.View.Meanwhile.All(state => state.IsJob()), $"while it ran it was {string.Join(", ", _machine.View.Meanwhile)}", run);
        var status = await _machine.PollAsync(limit.Token) ?? await _machine.PollAsync(limit.Token); // The rest of the fault may affect the first poll.
        if (status is null) return "unknown";
        var truth = await _machine.AskTruthAsync(limit.Token);
        var wanted = ExpectedReport.StateOf(one, run, truth, status);
        Check(status.State == wanted.State && wanted.Words.All(word => status.Reason.Contains(word, StringComparison.Ordinal)), $"the state is {status.State} '{status.Reason}' and not {wanted.State} '{string.Join(' ', wanted.Words)}'", run);

        // A lost link is one event, and so is each active cause: the abort input, a switch, an axis that was switched off.
        var events = (run.Result is { Outcome: JobOutcome.LinkLost } ? 1 : 0) + (truth.Abort ? 1 : 0) + (truth.Limits.Length > 0 ? 1 : 0) + (truth.OffByError.Length > 0 ? 1 : 0);
        Check(_machine.View.Alarms.Count <= Math.Max(1, events), $"{_machine.View.Alarms.Count} alarms: {string.Join(" | ", _machine.View.Alarms.Select(alarm => $"{alarm.Cause} {alarm.What}"))}", run);
        Check(run.IsComplete || _machine.View.Alarms.Count > 0 || run.Result is null or { FrameOrigin: null }, "it ended before its end, and no alarm tells it", run);
        Check(!_machine.HasHeight || IsToolSafe(run, truth), $"the tool stands at {_machine.ToolHeight}, the work at {_machine.TopOfWork}", run);
        return status.State.ToString();
    }

    /// <summary>A tool that an axis holds is over the work where the machine may move on; where nothing could raise it a sentence says so, or the link that
    /// was lost cannot.</summary>
    private bool IsToolSafe(FaultyRun run, MachineTruth truth)
    {
        var over = _machine.TopOfWork + (one.IsRun && run.Result?.FrameOrigin is not null ? _machine.Clearance - 2 : -2);
        return _machine.ToolHeight >= over || run.Sentence.Contains("could not be raised", StringComparison.Ordinal) || run.Result is { PositionDoubt.Length: > 0 } || truth.Abort || truth.Off.Length > 0 || one.Fault.Kind is FaultKind.PowerCycle;
    }

    private bool IsAt(CountsPoint goal) => Math.Abs(_machine.Controller.MotorPlace(0) - goal.X) <= MostError && Math.Abs(_machine.Controller.MotorPlace(1) - goal.Y) <= MostError;

    /// <summary>The next host cuts the part at its place or receives the reason why not: again, behind a homing, or what is left of it. It comes again
    /// while the rest of
    /// the fault meets it, once the axes at rest were freed, and with the operator's remedy where the machine position is unknown.</summary>
    private async Task NextAsync(FaultyRun run)
    {
        var isResumed = one.Activity is not (HostActivity.Run or HostActivity.Stop) && one.IsRun && !run.IsComplete;
        if (isResumed) Interrupted(run);
        var next = await UntilHeardAsync(isResumed);
        if (IsStanding)
        {
            Check(!next.IsComplete || MayLoseSteps || IsRight(next), "the next run is complete and wrong", next);
            _machine.Free(one.Fault);
            if (!next.IsComplete) next = await AgainAsync(next, isResumed);
        }

        Check(next.Refusal is not null || MayLoseSteps || IsRight(next) || next.Result?.Outcome is JobOutcome.Refused, "the next run is neither right nor refused", next);
        Check(run.Result is not { PositionDoubt.Length: > 0 } || one.Activity == HostActivity.Home || !next.IsComplete, "the next run goes by a position that is in doubt", next);
        if (isResumed) Check(next.CutCounts <= MostCounts, "the next run has cut something twice", next);
        if (!IsRight(next)) await RemedyAsync(next, isResumed);
        Check((_machine.Rest().Outputs & 1) == 0, "the tool is on after the next run", next);
    }

    /// <summary>Only the machine position is unknown: with the motors on and the origin set again, or after homing, the part or its rest is cut.</summary>
    private async Task RemedyAsync(FaultyRun refused, bool isResumed)
    {
        var unpowered = await _machine.SwitchMotorsOnAsync(limit.Token);
        Check(unpowered.Length == 0, "the motors cannot be switched on: " + unpowered, refused);
        if (one.Activity != HostActivity.Home) await _machine.SetOriginAnewAsync(limit.Token);
        var next = await AgainAsync(refused, isResumed);
        Check(IsRight(next) || (MayLoseSteps && isResumed), "with the operator's remedy it is not right", next);
        if (isResumed) Check(next.CutCounts <= MostCounts, "with the operator's remedy it has cut something twice", next);
    }

    /// <summary>The whole part was cut at its place. Where only the end of the run before was lost, nothing is left to cut. A record that begins before the
    /// run holds the jam itself, until the controller ended it at its position error limit.</summary>
    private bool IsRight(FaultyRun run) =>
        ((run.IsComplete && IsItsPlace(run.Zero)) || run.IsNothingLeft) && run.IsCutRightWithin(one.Fault.Kind == FaultKind.Jam && one.Activity is not (HostActivity.Run or HostActivity.Stop) ? JammedMm : FaultyRun.HealthyFollowingMm);

    private async Task<FaultyRun> UntilHeardAsync(bool isResumed)
    {
        var next = await OnceMoreAsync(isResumed);
        for (var host = 0; host < 4 && next.Result is null or { Outcome: JobOutcome.LinkLost }; host++) next = await AgainAsync(next, isResumed);
        return next;
    }

    private Task<FaultyRun> AgainAsync(FaultyRun before, bool isResumed)
    {
        _machine.Rest(); // A host that connects while a job of another one continues must wait.
        if (isResumed) Interrupted(before);
        return OnceMoreAsync(isResumed);
    }

    private bool IsItsPlace(CountsPoint? zero) =>
        zero is { } at && Math.Abs(at.X - _zero.X) <= (one.Activity == HostActivity.Home ? HomingTolerance : 0) && Math.Abs(at.Y - _zero.Y) <= (one.Activity == HostActivity.Home ? HomingTolerance : 0);

    /// <summary>A run that did not start left no state: the previous one is resumed.</summary>
    private void Interrupted(FaultyRun run)
    {
        if (run.Result is { FrameOrigin: not null }) _journal = run.Journal;
    }

    private async Task<FaultyRun> OnceMoreAsync(bool isResumed)
    {
        if (isResumed && _journal.Length > 0) return await ResumeAsync(null);
        if (one.Activity == HostActivity.Home && await _machine.HomeAsync(limit.Token) is { IsComplete: false } unhomed) return unhomed;
        return await _machine.RunAsync(one.Mode, null, limit.Token);
    }
}
