using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>One run of one motion program: prepare, cut stroke by stroke, bring to rest, leave the controller as found.</summary>
internal sealed class Job
{
    private static readonly int[] OwnThreads = [ResidentProgram.MainThread, ResidentProgram.WatchdogThread];

    private readonly MotionProgram _whole;
    private MotionProgram _program;
    private readonly ControllerSession _session;
    private readonly JobOptions _options;
    private readonly JobLog _log;
    private readonly StopOrder _stop;
    private readonly JobLedger _ledger;
    private readonly JobMachine _machine;
    private readonly Func<IJobStrategy> _strategyOfRest;
    private IJobStrategy _strategy;
    private readonly ResidentProgram _resident;
    private readonly ProgramMemory _memory;
    private readonly ControllerSnapshot _found;
    private readonly OperatorStop _stopper;
    private readonly bool _isHandMove;
    private bool _touched;

    /// <summary>Where an output is the tool: the height at which the job is cut, while the operator may have moved the machine away from it, in this job or
    /// since the one that it resumes, the controller's own counts.</summary>
    private int? _heightOfCut;

    public Job(MotionProgram program, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, JobJournal journal, StopOrder stop, HandOperation? hand = null)
    {
        _session = session;
        _options = options;
        _stop = stop;
        _whole = program;
        _heightOfCut = program.Profile is { Height: null, Axes.Z: not null } ? options.HeightOfCut : null;
        var rest = options.From == default ? RemainingProgram.Whole(program) : RestFrom(options.From, options.LeadIn);
        _program = rest.Program;
        _ledger = new JobLedger(program, rest, options.From, options.Polled);
        _ledger.Begin();
        var mark = hand is null ? MachineMemory.NewMark(session.Time.GetUtcNow()) : 0;
        _machine = new JobMachine(session, program, options, _ledger, () => _log!.Polled(), _stop) { Mark = mark };
        _isHandMove = hand is not null;
        _log = new JobLog(_machine, _ledger, journal, progress, session.Time, options.Told);
        _memory = new ProgramMemory(session);
        _machine.Hold.Changed = _log.ControlChanged;
        _machine.Hold.Parted = _log.SequenceDone;
        _machine.Opened = _log.Opened;
        _found = new ControllerSnapshot(session, _memory, program.Profile, options, _log);
        _resident = hand?.Resident ?? ResidentServer.Program(options.Mode(), program.Profile);
        _strategyOfRest = () => options.Mode() switch
        {
            JobMode.Stream => new StrokeByStroke(_program, _machine, _ledger, _log, new StreamStrategy(_machine, _ledger)),
            JobMode.Calls => new StrokeByStroke(_program, _machine, _ledger, _log, new CallsStrategy(_machine, _ledger)),
            JobMode.Program => new ProgramStrategy(_program, _machine, _ledger, _log, _memory, options),
            _ => throw new ArgumentOutOfRangeException(nameof(options)),
        };
        _strategy = hand?.Create(_machine) ?? _strategyOfRest();
        _stopper = new OperatorStop(session, program.Profile.OffAtStop, OwnThreads, program.Profile.Axes.Letters);
    }

    public async Task<JobResult> RunAsync()
    {
        JobStep? step = null;
        try
        {
            step = await RunToTheEndAsync().ConfigureAwait(false);
        }
        finally
        {
            // An exception of our own is being thrown: the machine is stopped first.
            if (step is null) await BringToRestAsync(JobStep.Done).ConfigureAwait(false);
        }

        var (end, standstill) = await BringToRestAsync(step).ConfigureAwait(false);
        var notRestored = await LeaveAsFoundAsync().ConfigureAwait(false);
        var result = Result(end, standstill, notRestored);
        _options.Control?.Over(result);
        return Journalled(_options.Judge?.Invoke(result) ?? result);
    }

    private JobStep Stopped => new(JobOutcome.Stopped, _options.Control?.StopReason ?? Wording.Get("Job.StoppedOperator"), null);

    private JobResult Journalled(JobResult result)
    {
        try
        {
            _log.End(result);
            return result;
        }
        catch (IOException failure)
        {
            return result with { Sentence = Wording.Get("Job.JournalEndNotWritten", result.Sentence, SystemReason.Of(failure)) };
        }
    }

    /// <summary>Everything up to the end of the last stroke. A stop or failure, whether of operator, controller, link or disk, is returned as a
    /// value.</summary>
    private async Task<JobStep> RunToTheEndAsync()
    {
        try
        {
            var step = await BusyStepAsync().ConfigureAwait(false) is { Ends: true } busy ? busy : await RunFreeMachineAsync().ConfigureAwait(false);

            // A motion that ended early or a halted thread is a consequence of the stop.
            return step.Outcome == JobOutcome.Refused && _stop.IsPressed ? Stopped : step;
        }
        catch (OperationCanceledException) when (_stop.IsPressed)
        {
            return Stopped;
        }
        catch (ControllerException failure)
        {
            return JobStep.LinkLost(failure.Message);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return JobStep.Broken(Wording.Get("Job.JournalNotWritable", SystemReason.Of(failure)));
        }
    }

    private async Task<JobStep> BusyStepAsync() =>
        await _session.BusyReasonAsync(_stop.Work).ConfigureAwait(false) is { } busy ? JobStep.Broken(busy) : JobStep.Done;

    /// <summary>Called when the machine is free: from here on the operator's stop acts on it at once.</summary>
    private async Task<JobStep> RunFreeMachineAsync()
    {
        _touched = true;
        _stop.BrakeBy(_stopper.Begin);
        try
        {
            return await PrepareAsync().ConfigureAwait(false) is { Ends: true } unprepared ? unprepared : await CutAsync().ConfigureAwait(false);
        }
        finally
        {
            _stop.BrakeBy(null);
        }
    }

    private async Task<JobStep> PrepareAsync()
    {
        if (!await _stopper.RehearseAsync().ConfigureAwait(false)) return JobStep.Broken(Wording.Get("Job.StopTestFailed"));
        var mark = await MarkAsync().ConfigureAwait(false);
        await _session.NoteSoftLimitsAsync(_options.SoftLimits, _stop.Work).ConfigureAwait(false);
        if (await _found.BorrowAsync(_resident.Text, _stop.Work).ConfigureAwait(false) is { } refused) return _machine.Refuse(refused, "");
        var acceleration = _program.Profile.AccelerationCounts;
        var axes = _program.Profile.Axes.Letters;
        string[] settings = ["AC", "DC"];
        List<string> commands = [.. _program.Profile.OffAtAbort.Select(OperatorStop.Off), "CAS", ResidentServer.DefineVariables(_program.Profile), ResidentServer.MarkCommand(mark)]; // whatever somebody left on or selected
        commands.AddRange(ResidentServer.DefineHeight(_program.Profile, _machine.FrameGiven, _machine.Lift, !_isHandMove));
        commands.AddRange(_session.Found.MotorsOff.Where(axes.Contains).Select(letter => $"SH{letter}"));
        commands.AddRange(Programs.Subprograms.AccelerationCommands(_program.Profile));
        commands.AddRange(_session.SoftLimitCommands(_options.SoftLimits));
        commands.AddRange(PositionErrorLimit.Commands(_program.Profile, _session.Found));
        commands.Add(ResidentServer.StartCommand(_resident));
        if (await _machine.SendAllAsync(commands).ConfigureAwait(false) is { Ends: true } end) return end;
        if (await SettingCheck.ReadBackAsync(_machine, [.. settings.SelectMany(name => axes.Select(axis => ($"_{name}{axis}", (double)acceleration, SettingCheck.Acceleration)))]).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await _machine.AwaitWatchdogAsync().ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        if (_options.Mode() != JobMode.Stream && await _machine.Hold.SendRatioAsync().ConfigureAwait(false) is { Ends: true } unset) return unset; // a stream sends it with every sequence
        if (await _strategy.StartAsync().ConfigureAwait(false) is { Ends: true } unready) return unready;
        if (await MotorTypeSetting.SetAsync(_machine).ConfigureAwait(false) is { Ends: true } otherMotor) return otherMotor;
        if (await _machine.TakeFrameAsync().ConfigureAwait(false) is { Ends: true } unknown) return unknown;
        _log.Begin(_options, _session.Identity.Model, ProgramFingerprint.Of(_whole));
        return JobStep.Done;
    }

    /// <summary>The job's own mark. A move by hand leaves that of the last job, negative: what the watchdog would keep of the move is nobody's, and the job
    /// can still be resumed.</summary>
    private async Task<int> MarkAsync() =>
        _machine.Mark != 0 ? _machine.Mark : -Math.Abs((int)(await _machine.AskAtRestAsync(ResidentProgram.Variables.JobMark).ConfigureAwait(false) ?? 0.0));

    private async Task<JobStep> CutAsync()
    {
        if (IsTooFar) return JobStep.Broken(Wording.Get("Job.BeyondCounterRange", _machine.Frame.X, _machine.Frame.Y));
        var step = await FromStartAsync().ConfigureAwait(false);
        while (step.IsParted) step = await GoOnAsync().ConfigureAwait(false);
        return step;
    }

    private async Task<JobStep> FromStartAsync()
    {
        if (!_isHandMove && await UpAndTurningAsync().ConfigureAwait(false) is { Ends: true } notReady) return notReady;
        if (_options.Frame is not null && _options.From == default && _program.Strokes.Count > 0 && await RapidMove.ToAsync(_machine, _program.Start).ConfigureAwait(false) is { Ends: true } lost) return lost;
        return await ToHeightOfCutAsync().ConfigureAwait(false) is { Ends: true } away ? away : await ToTheEndAsync().ConfigureAwait(false);
    }

    /// <summary>The job stands held and what was under way is given up: stays so, and then cuts what is left as a resumed job does, from the place where it
    /// stood.</summary>
    private async Task<JobStep> GoOnAsync()
    {
        await _strategy.StoppedAsync(_machine.PartedCounter).ConfigureAwait(false);
        if (_whole.Profile is { Height: null, Axes.Z: not null }) _heightOfCut ??= _machine.State.Position.Z; // held again on the way back it is still that of the cut
        if (await _machine.Hold.AwayAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var rest = RestFrom(_ledger.PartedAt, leadIn: 0.0);
        _ledger.GoOn(rest);
        _program = rest.Program;
        _strategy = _strategyOfRest();
        return await ToHeightOfCutAsync().ConfigureAwait(false) is { Ends: true } away ? away : await ToTheEndAsync().ConfigureAwait(false);
    }

    /// <summary>Nothing of the job moves the Z axis where an output is the tool: it goes back to where it was, up before the way to what is left and down
    /// behind it. A hold meanwhile is waited for, or parts the job again.</summary>
    private async Task<JobStep> ToHeightOfCutAsync()
    {
        if (_heightOfCut is { } height && _machine.State.Position.Z != height)
        {
            var next = _program.Strokes.Count > 0 ? _program.Strokes[0].Start : _program.Finish ?? _machine.Here;
            var place = (next + _machine.Frame) with { Z = height };
            if (await new HandMove(_machine, place, withHeight: true).CutAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        }

        _heightOfCut = null;
        return JobStep.Done;
    }

    private RemainingProgram RestFrom(JobPlace place, double leadIn) => RemainingProgram.From(_whole, place, leadIn, new AngleQuantum(_whole.Profile.AngleQuantumDegrees).Keep);

    private async Task<JobStep> ToTheEndAsync()
    {
        if (await _strategy.CutAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        _machine.Hold.CutBegins();
        if (!_isHandMove && await _machine.Tool.TurnAsync(on: false).ConfigureAwait(false) is { Ends: true } turning) return turning;
        if (_program.Finish is { } finish && await RapidMove.ToAsync(_machine, finish).ConfigureAwait(false) is { Ends: true } unfinished) return unfinished;
        return new JobStep(JobOutcome.Complete, Wording.Count("Job.DoneSegments", _ledger.Executed), null);
    }

    /// <summary>First the tool goes up, then the spindle turns.</summary>
    private async ValueTask<JobStep> UpAndTurningAsync() =>
        await _machine.Tool.ClearAsync().ConfigureAwait(false) is { Ends: true } down ? down : await _machine.Tool.TurnAsync(on: true).ConfigureAwait(false);

    /// <summary>Whether the job would leave the controller's 32 bits.</summary>
    private bool IsTooFar => !_machine.ControllerFrame.Holds(MotionExtents.Of(_program));

    /// <summary>Tool off, stop, our threads halted, at rest; after a complete job only the threads are left to stop. Tried over a lost link too, because
    /// the other handle may still work.</summary>
    private async Task<(JobStep Step, StandstillReport? Standstill)> BringToRestAsync(JobStep step)
    {
        if (!_touched) return (step, null);
        try
        {
            var standstill = await _stopper.FinishAsync(_options.PollInterval, CancellationToken.None).ConfigureAwait(false);
            _ledger.IsStopping = step.Ends;
            if (step.Outcome == JobOutcome.LinkLost && _machine.FrameTaken is null) return (step, null); // it has not moved; what answers now may have been switched off in between
            if (await HasForgottenAsync().ConfigureAwait(false)) return (Forgotten(step), null);
            step = WithTool(step, standstill);
            step = Followed(step, await new FollowingCheck(_session, _program.Profile).AtRestAsync().ConfigureAwait(false));
            var lost = await WhyStepsMayBeLostAsync(step).ConfigureAwait(false); // a tool that goes up leaves another stop code
            if (step.Ends) await _strategy.StoppedAsync(standstill.SegmentCounter).ConfigureAwait(false);
            if (_isHandMove || _program.Profile is { Height: null, Spindle: null }) return (Doubted(step, lost), standstill);
            int? clearance = _machine.FrameTaken is { } frame ? frame.Z + _program.Profile.ClearanceCounts : null;
            var (rest, warning) = await new ToolRetreat(_session, _program.Profile).RunAsync(standstill, clearance, step.Doubt.Length > 0, _options.PollInterval).ConfigureAwait(false);
            return (Doubted(warning.Length == 0 ? step : step with { Sentence = $"{step.Sentence} {warning}" }, lost), rest);
        }
        catch (ProtocolViolationException unknown) when (!_session.StopHandle.IsBroken)
        {
            return (JobStep.Broken(step.Ends ? $"{step.Sentence} {unknown.Message}" : unknown.Message), null);
        }
        catch (ControllerException failure)
        {
            var lost = step.Outcome == JobOutcome.LinkLost ? step : JobStep.LinkLost(failure.Message);
            return (lost with { Sentence = lost.Sentence + LastWord }, null);
        }
    }

    /// <summary>The controller was switched off or reset since the job began: its variables are gone, and it counts from wherever it stood. What it says of
    /// its place is of no use.</summary>
    private async ValueTask<bool> HasForgottenAsync() => _machine.FrameTaken is not null && await _machine.AskAtRestAsync(ResidentProgram.Variables.JobMark).ConfigureAwait(false) is null;

    /// <summary>A tool that an axis holds stands where it is: how high that is nobody knows.</summary>
    private static JobStep Forgotten(JobStep step) => (step.Ends ? step with { Sentence = $"{step.Sentence} {Wording.Get("Job.ControllerReset")}" } : JobStep.Broken(Wording.Get("Job.ControllerReset"))) with { Doubt = Wording.Get("Job.ControllerResetDoubt") };

    /// <summary>A tool that was on behind the job has marked the work where it stood; one that is still on is for hands.</summary>
    private static JobStep WithTool(JobStep step, StandstillReport standstill)
    {
        if (standstill.WasToolOn && !step.Ends) step = JobStep.Deviated(Wording.Get("Job.ToolWasOn", standstill.Position.X, standstill.Position.Y));
        return standstill.IsToolOn ? step with { Sentence = $"{step.Sentence} {Wording.Get("Job.ToolStaysOn")}" } : step;
    }

    /// <summary>Motors that are not where they were sent: what was cut is not known, and from here on neither is the machine's position.</summary>
    /// <param name="off">The axes with their position errors; empty for none.</param>
    private JobStep Followed(JobStep step, string off)
    {
        if (off.Length == 0 || step.Doubt.Length > 0) return step;
        var told = Wording.Get("Job.MotorsNotAtPosition", off);
        var ended = step.Ends ? step with { Sentence = $"{step.Sentence} {told}" } : _isHandMove ? JobStep.Broken(told) : JobStep.Deviated(told);
        return ended with { Doubt = Wording.Get("Job.DidNotFollow") };
    }

    /// <summary>An abort stops steppers without a ramp (galil-dmc.md D); nothing counts the steps that they lose.</summary>
    /// <returns>Empty where none may have lost steps.</returns>
    private async ValueTask<string> WhyStepsMayBeLostAsync(JobStep step)
    {
        if (!step.Ends || step.Doubt.Length > 0 || _machine.StoodAt is not { } stood) return "";
        var place = await PlaceQuestions.AskAsync(_session, _program.Profile.Axes).ConfigureAwait(false);
        return (MachineMemory.Empty with { Rest = stood }).WhyStepsMayBeLost(place, place.StoppedHard);
    }

    private static JobStep Doubted(JobStep step, string why) => why.Length == 0 ? step : step with { Sentence = $"{step.Sentence} {Wording.Get("Job.PositionInDoubt", why)}", Doubt = why };

    /// <summary>What was last known. After the link is lost the controller continues unseen: with its buffer, or a program with all its strokes, until the
    /// watchdog trips.</summary>
    private string LastWord => _machine.Known is { } known
        ? Wording.Get("Job.LastReport", known.Position.X, known.Position.Y, _ledger.Executed)
        : "";

    /// <summary>Restores the found program, speeds and motors; the machine is at rest and our threads are halted.</summary>
    private async Task<IReadOnlyList<string>> LeaveAsFoundAsync()
    {
        if (!_touched) return [];
        try
        {
            await _machine.EndWatchAsync().ConfigureAwait(false);
            var refused = await _memory.GiveBackAsync(CancellationToken.None).ConfigureAwait(false);
            await _session.LeaveToOthersAsync(_machine.Feed.SetByOthers).ConfigureAwait(false);
            var settings = await _session.RestoreAsync(CancellationToken.None).ConfigureAwait(false);
            if (refused is not null) return [refused.Explain(), .. settings];
            if (settings.Count == 0) _found.GivenBack();
            return [.. _found.Lost, .. settings];
        }
        catch (Exception unwritten) when (unwritten is IOException or UnauthorizedAccessException)
        {
            return [Wording.Get("Job.EarlierJournalNotClosed", SystemReason.Of(unwritten))];
        }
        catch (ControllerException failure)
        {
            return [Wording.Get("Job.ControllerNotRestored", failure.Message)];
        }
    }

    private JobResult Result(JobStep step, StandstillReport? standstill, IReadOnlyList<string> notRestored) => new()
    {
        Outcome = step.Outcome,
        Loss = step.Loss,
        Sentence = step.Sentence,
        SegmentsSent = _ledger.Sent,
        SegmentsExecuted = _ledger.Executed,
        SegmentsUncut = _ledger.Uncut,
        Seconds = _machine.Seconds,
        Underruns = _ledger.Underruns,
        Rejected = _ledger.Rejected,
        FinalPosition = standstill?.Position ?? _machine.Known?.Position,
        FrameOrigin = _machine.FrameTaken,
        Place = _ledger.Place,
        Holds = _machine.Hold.Holds,
        IsEndKnown = standstill is not null || !_touched,
        PositionDoubt = step.Doubt,
        Refusal = step.Refusal?.ToRefusal(),
        PolledTrace = _ledger.Trace,
        ExecutedEntityIndices = _ledger.Entities,
        ExecutedByStroke = _ledger.ExecutedByStroke,
        LengthByStroke = _ledger.LengthByStroke,
        Diagnostics = [.. _ledger.Diagnostics, .. _ledger.Warnings],
        NotRestored = notRestored,
    };
}
