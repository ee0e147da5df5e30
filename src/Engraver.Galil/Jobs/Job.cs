using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>One run of one motion program: prepare, cut stroke by stroke, bring to rest, leave the controller as found.</summary>
internal sealed class Job
{
    private static readonly int[] s_ownThreads = [ResidentProgram.MainThread, ResidentProgram.WatchdogThread];

    private readonly MotionProgram _whole;

    /// <summary>The whole program up to the end of the section, if it has several.</summary>
    private readonly MotionProgram _wanted;
    private readonly ControllerSession _session;
    private readonly JobOptions _options;
    private readonly JobLog _log;
    private readonly StopOrder _stop;
    private readonly JobLedger _ledger;
    private readonly JobMachine _machine;
    private readonly ControllerProgramMemory _memory;
    private readonly ControllerSnapshot _found;
    private readonly ControllerPreparation _preparation;
    private readonly OperatorStop _stopper;
    private readonly JobStandstill _standstill;
    private readonly bool _isHandMove;
    private MotionProgram _program;
    private IJobStrategy _strategy;
    private bool _touched;

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which the job is cut, the controller's own counts, while the
    /// operator may have moved the machine away from it, in this job or since the one that it resumes; otherwise null.</summary>
    private int? _heightOfCut;

    public Job(MotionProgram program, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, JobJournal journal, StopOrder stop, HandOperation? hand = null)
    {
        (_whole, _session, _options, _stop, _isHandMove) = (program, session, options, stop, hand is not null);
        _wanted = options.Until is { } end ? program.Until(end) : program;
        _heightOfCut = HasIdleHeight ? options.HeightOfCut : null;
        var rest = options.From == default ? RemainingProgram.Whole(_wanted) : RestFrom(options.From, options.LeadIn);
        _program = rest.Program;
        _ledger = new JobLedger(program, rest, options.From, options.Polled);
        _ledger.Begin();
        var mark = _isHandMove ? 0 : StoredMachineState.NewMark(session.Time.GetUtcNow());
        _log = new JobLog(_ledger, journal, progress, session.Time, options.Warned);
        _machine = new JobMachine(session, program, options, _ledger, _log, stop) { Mark = mark };
        _memory = new ControllerProgramMemory(session);
        _found = new ControllerSnapshot(session, _memory, program.Profile, options, _log);
        _preparation = new ControllerPreparation(session, program.Profile, program.LongestWait, options, hand?.Resident ?? ResidentServer.Program(options.Mode(), program.Profile), _isHandMove);
        _stopper = new OperatorStop(session, program.Profile.OffAtStop, s_ownThreads, program.Profile.Axes.Letters);
        _standstill = new JobStandstill(session, _machine, _ledger, options, _stopper, _isHandMove);
        _strategy = hand?.Create(_machine) ?? StrategyOf(_options.Mode());
    }

    public async Task<JobResult> RunAsync()
    {
        JobEnd? end = null;
        try
        {
            end = await RunToTheEndAsync().ConfigureAwait(false);
        }
        finally
        {
            // An internal error is being thrown: the machine is stopped first.
            if (end is null) await BringToRestAsync(JobEnd.Complete("")).ConfigureAwait(false);
        }

        (end, var standstill) = await BringToRestAsync(end).ConfigureAwait(false);
        var notRestored = await LeaveAsFoundAsync().ConfigureAwait(false);
        var result = Result(end, standstill, notRestored);
        _options.Control?.Complete(result);
        return Journalled(_options.Judge?.Invoke(result) ?? result);
    }

    /// <summary>Everything up to the end of the last stroke. The only place that turns the early end of a step, a stop, or a failure of controller, link
    /// or disk into a value.</summary>
    private async Task<JobEnd> RunToTheEndAsync()
    {
        try
        {
            var early = await JobEnd.OfAsync(RunFreeMachineAsync).ConfigureAwait(false);
            if (early is null) return Done;

            // A motion that ended early or a halted thread is a consequence of the stop.
            return early.Outcome == JobOutcome.Refused && _stop.IsPressed ? Stopped : early;
        }
        catch (OperationCanceledException) when (_stop.IsPressed)
        {
            return Stopped;
        }
        catch (ControllerException failure)
        {
            return JobEnd.LinkLost(failure.Message);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return JobEnd.Broken(Wording.Get("Job.JournalNotWritable", SystemErrorText.FromException(failure)));
        }
    }

    private JobEnd Done => _options switch
    {
        { Until: null } => JobEnd.Complete(Wording.Count("Job.DoneSegments", _ledger.Executed)),
        { SectionEnd: JobOutcome.ToolChange } => JobEnd.OfSection(JobOutcome.ToolChange, Wording.Count("Job.DoneBeforeToolChange", _ledger.Executed)),
        _ => JobEnd.OfSection(_options.SectionEnd, Wording.Count("Job.DoneBeforeStop", _ledger.Executed)),
    };

    private JobEnd Stopped => new(JobOutcome.Stopped, _options.Control?.StopReason ?? Wording.Get("Job.StoppedOperator"));

    /// <summary>From when the machine is free, the operator's stop acts on it at once.</summary>
    private async ValueTask RunFreeMachineAsync()
    {
        if (await _session.BusyReasonAsync(_stop.Work).ConfigureAwait(false) is { } busy) throw JobEnd.Broken(busy).ToException();
        _touched = true;
        _stop.BrakeBy(_stopper.Start);
        try
        {
            if (!await IsCompletedAsync(PrepareAsync).ConfigureAwait(false)) throw Stopped.ToException(); // a hold before the job's first motion
            await CutAsync().ConfigureAwait(false);
        }
        finally
        {
            _stop.BrakeBy(null);
        }
    }

    private async ValueTask PrepareAsync()
    {
        await _preparation.RunAsync(_machine, _found, _stopper).ConfigureAwait(false);
        await _strategy.StartAsync().ConfigureAwait(false);
        await MotorTypeSetting.SetAsync(_machine).ConfigureAwait(false);
        await _machine.TakeFrameAsync().ConfigureAwait(false);
        _log.Begin(_machine, _options, _session.Identity.Model, ProgramFingerprint.Of(_whole));
    }

    /// <summary>Cuts the program; and what is left of it, each time that a hold has given up the motion.</summary>
    private async ValueTask CutAsync()
    {
        // The job would leave the controller's 32 bits.
        if (!_machine.Frame.ToController.IsInRange(MotionExtents.Of(_program))) throw JobEnd.Broken(Wording.Get("Job.BeyondCounterRange", _machine.Frame.Origin.X, _machine.Frame.Origin.Y)).ToException();
        // It may be given up again, also on the way back to the path.
        var isCut = await IsCompletedAsync(CutFromStartAsync).ConfigureAwait(false);
        while (!isCut) isCut = await IsCompletedAsync(RemainHeldAsync).ConfigureAwait(false) && await IsCompletedAsync(CutToTheEndAsync).ConfigureAwait(false);
    }

    /// <summary>Runs a step in the phase of the strategy that is in force at its start.</summary>
    /// <returns>False where a hold has given up the motion.</returns>
    private async ValueTask<bool> IsCompletedAsync(Func<ValueTask> step)
    {
        using var whole = _machine.Enter(_strategy.Whole);
        try
        {
            await step().ConfigureAwait(false);
            return true;
        }
        catch (GivenUpException)
        {
            return false;
        }
    }

    /// <summary>First the tool goes up, then the spindle turns.</summary>
    private async ValueTask CutFromStartAsync()
    {
        if (!_isHandMove)
        {
            await _machine.Tool.ClearAsync().ConfigureAwait(false);
            _machine.Tool.Terms = _program.Strokes.Count > 0 ? _program.Strokes[0].Terms : null;
            await _machine.Tool.TurnAsync(on: true).ConfigureAwait(false);
        }

        if (_options.Frame is not null && _options.From == default && _program.Strokes.Count > 0) await RapidMove.ToAsync(_machine, _program.Start).ConfigureAwait(false);
        await CutToTheEndAsync().ConfigureAwait(false);
    }

    /// <summary>The job is held and its motion was given up: remains held. What is left is then cut as a resumed job does, from the place where it was held,
    /// with a strategy of its own.</summary>
    private async ValueTask RemainHeldAsync()
    {
        await _strategy.StoppedAsync(_machine.CounterGivenUp).ConfigureAwait(false);
        if (HasIdleHeight) _heightOfCut ??= _machine.State.Position.Z; // after another hold on the way back it is still that of the cut
        await _machine.Hold.AwayAsync().ConfigureAwait(false);
        var rest = RestFrom(_ledger.PlaceGivenUp, leadIn: 0.0);
        _ledger.Continue(rest);
        _program = rest.Program;
        _strategy = StrategyOf(_options.Mode());
    }

    private async ValueTask CutToTheEndAsync()
    {
        await ReturnToHeightOfCutAsync().ConfigureAwait(false);
        await _strategy.CutAsync().ConfigureAwait(false);
        _machine.Hold.CutBegins();
        if (!_isHandMove) await _machine.Tool.TurnAsync(on: false).ConfigureAwait(false);
        if (_program.Finish is { } finish) await RapidMove.ToAsync(_machine, finish).ConfigureAwait(false);
    }

    /// <summary>The job does not move the Z axis where an output is the tool: it returns to its height, up before the way to what is left or down after
    /// it. A hold meanwhile is waited for, or gives up the motion again.</summary>
    private async ValueTask ReturnToHeightOfCutAsync()
    {
        if (_heightOfCut is { } height && _machine.State.Position.Z != height)
        {
            var next = _program.Strokes.Count > 0 ? _program.Strokes[0].Start : _program.Finish ?? _machine.Here;
            await new HandMove(_machine, (next + _machine.Frame.Origin) with { Z = height }, withHeight: true).CutAsync().ConfigureAwait(false);
        }

        _heightOfCut = null;
    }

    /// <summary>An output is the tool of a machine with a Z axis.</summary>
    private bool HasIdleHeight => _whole.Profile is { Height: null, Axes.Z: not null };

    private RemainingProgram RestFrom(JobPosition place, double leadIn) => RemainingProgram.From(_wanted, place, leadIn, new AngleQuantum(_whole.Profile.AngleQuantumDegrees).Quantize);

    private IJobStrategy StrategyOf(JobMode mode) => mode switch
    {
        JobMode.Stream => new StrokeByStroke(_program, _machine, _ledger, _log, new StreamStrategy(_machine, _ledger)),
        JobMode.Calls => new StrokeByStroke(_program, _machine, _ledger, _log, new CallsStrategy(_machine, _ledger)),
        JobMode.Program => new ProgramStrategy(_program, _machine, _ledger, _log, _memory, _options),
        _ => throw new ArgumentOutOfRangeException(nameof(mode)),
    };

    private async Task<(JobEnd End, StandstillReport? Standstill)> BringToRestAsync(JobEnd end)
    {
        await _machine.Commands.EndBeatingAsync().ConfigureAwait(false);
        return _touched ? await _standstill.ReachAsync(end, _strategy).ConfigureAwait(false) : (end, null);
    }

    private async Task<IReadOnlyList<string>> LeaveAsFoundAsync() => _touched ? await _found.RestoreAsync(_machine.Watch).ConfigureAwait(false) : [];

    private JobResult Journalled(JobResult result)
    {
        try
        {
            _log.End(_machine, result);
            return result;
        }
        catch (IOException failure)
        {
            return result with { Message = Wording.Get("Job.JournalEndNotWritten", result.Message, SystemErrorText.FromException(failure)) };
        }
    }

    private JobResult Result(JobEnd end, StandstillReport? standstill, IReadOnlyList<string> notRestored) => new()
    {
        Outcome = end.Outcome,
        Loss = end.Loss,
        Message = end.Sentence,
        SegmentsSent = _ledger.Sent,
        SegmentsExecuted = _ledger.Executed,
        SegmentsUncut = _ledger.Uncut,
        Seconds = _machine.Seconds,
        Underruns = _ledger.Underruns,
        Rejected = _ledger.Rejected,
        FinalPosition = standstill?.Position ?? _machine.Known?.Position,
        FrameOrigin = _machine.Frame.Taken,
        Place = _ledger.Place,
        Holds = _machine.Hold.Holds,
        IsEndKnown = standstill is not null || !_touched,
        PositionDoubt = end.Doubt,
        Refusal = end.Refusal?.ToRefusal(),
        PolledTrace = _ledger.Trace,
        ExecutedEntityIndices = _ledger.Entities,
        ExecutedByStroke = _ledger.ExecutedByStroke,
        LengthByStroke = _ledger.LengthByStroke,
        Diagnostics = [.. _ledger.Diagnostics, .. _ledger.Warnings],
        NotRestored = notRestored,
    };
}
