using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>One run of one motion program: prepare, cut stroke by stroke, bring to rest, leave the controller as found.</summary>
internal sealed class Job
{
    private static readonly int[] OwnThreads = [ResidentProgram.MainThread, ResidentProgram.WatchdogThread];

    private readonly MotionProgram _program;
    private readonly ControllerSession _session;
    private readonly JobOptions _options;
    private readonly JobLog _log;
    private readonly CancellationToken _stop;
    private readonly JobLedger _ledger;
    private readonly JobMachine _machine;
    private readonly IJobStrategy _way;
    private readonly ProgramMemory _memory;
    private readonly ControllerSnapshot _found;
    private readonly OperatorStop _stopper;
    private bool _touched;

    public Job(MotionProgram program, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, JobJournal journal, CancellationToken stop, CountsPoint? goTo = null)
    {
        _program = program;
        _session = session;
        _options = options;
        _stop = stop;
        _ledger = new JobLedger(program, options.KeepsPolledTrace);
        _machine = new JobMachine(session, program, options, _ledger, () => _log!.Polled(), stop);
        _log = new JobLog(_machine, _ledger, journal, progress, session.Time);
        _memory = new ProgramMemory(session);
        _found = new ControllerSnapshot(session, _memory, program.Profile, options, _log);
        _way = goTo is { } goal ? new HandMove(_machine, goal) : options.Mode switch
        {
            JobMode.Stream => new StrokeByStroke(program, _machine, _ledger, _log, new StreamStrategy(_machine, _ledger)),
            JobMode.Calls => new StrokeByStroke(program, _machine, _ledger, _log, new CallsStrategy(_machine, _ledger)),
            JobMode.Program => new ProgramStrategy(program, _machine, _ledger, _log, _memory, options),
            _ => throw new ArgumentOutOfRangeException(nameof(options)),
        };
        _stopper = new OperatorStop(session, program.Profile.ToolOutput, OwnThreads, program.Profile.Axes.Letters);
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
        return Journalled(_options.Judge?.Invoke(result) ?? result);
    }

    private static JobStep Stopped => new(JobOutcome.Stopped, Wording.Get("Job.StoppedOperator"), null);

    private JobResult Journalled(JobResult result)
    {
        try
        {
            _log.End(result);
            return result;
        }
        catch (IOException failure)
        {
            return result with { Sentence = Wording.Get("Job.JournalLastLineCould", result.Sentence, failure.Message) };
        }
    }

    /// <summary>Everything up to the end of the last stroke. A stop or failure, whether of operator, controller, link or disk, is returned as a value.</summary>
    private async Task<JobStep> RunToTheEndAsync()
    {
        try
        {
            var step = await BusyStepAsync().ConfigureAwait(false) is { Ends: true } busy ? busy : await RunFreeMachineAsync().ConfigureAwait(false);

            // A motion that ended early or a halted thread is a consequence of the stop.
            return step.Outcome == JobOutcome.Refused && _stop.IsCancellationRequested ? Stopped : step;
        }
        catch (OperationCanceledException) when (_stop.IsCancellationRequested)
        {
            return Stopped;
        }
        catch (ControllerException failure)
        {
            return JobStep.LinkLost(failure.Message);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return JobStep.Broken(Wording.Get("Job.JournalCannotWrittenJob", failure.Message));
        }
    }

    private async Task<JobStep> BusyStepAsync() =>
        await _session.BusyReasonAsync(_stop).ConfigureAwait(false) is { } busy ? JobStep.Broken(busy) : JobStep.Done;

    /// <summary>Called when the machine is free: from here on the operator's stop acts on it at once.</summary>
    private async Task<JobStep> RunFreeMachineAsync()
    {
        _touched = true;
        using var pressed = _stop.UnsafeRegister(stopper => ((OperatorStop)stopper!).Begin(), _stopper);
        return await PrepareAsync().ConfigureAwait(false) is { Ends: true } unprepared ? unprepared : await CutAsync().ConfigureAwait(false);
    }

    private async Task<JobStep> PrepareAsync()
    {
        await _stopper.RehearseAsync().ConfigureAwait(false);
        var resident = ResidentServer.Program(_options.Mode, _program.Profile);
        if (await _found.BorrowAsync(resident.Text, _stop).ConfigureAwait(false) is { } refused) return _machine.Refuse(refused, "");
        var acceleration = _program.Profile.AccelerationCounts;
        var axes = _program.Profile.Axes.Letters;
        string[] settings = ["AC", "DC"];
        var commands = new List<string> { JobMachine.Text($"CB {_program.Profile.ToolOutput}"), "CAS", ResidentServer.DefineVariables(_program.Profile) }; // whatever somebody left on or selected
        commands.AddRange(_session.Found.MotorsOff.Where(axes.Contains).Select(letter => $"SH{letter}"));
        commands.AddRange(Programs.Subprograms.AccelerationCommands(_program.Profile));
        commands.Add(ResidentServer.StartCommand(resident));
        if (await _machine.SendAllAsync(commands).ConfigureAwait(false) is { Ends: true } end) return end;
        if (await SettingCheck.ReadBackAsync(_machine, [.. settings.SelectMany(name => axes.Select(axis => ($"_{name}{axis}", (double)acceleration, SettingCheck.Acceleration)))]).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await _machine.AwaitWatchdogAsync().ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        if (await _way.StartAsync().ConfigureAwait(false) is { Ends: true } unready) return unready;
        if (await _machine.TakeFrameAsync().ConfigureAwait(false) is { Ends: true } unknown) return unknown;
        _log.Begin(_options, _session.Identity.Model);
        return JobStep.Done;
    }

    private async Task<JobStep> CutAsync()
    {
        if (IsTooFar) return JobStep.Broken(Wording.Get("Job.CannotCountToAll", _machine.Frame.X, _machine.Frame.Y));
        if (_options.Frame is not null && _program.Strokes.Count > 0 && await RapidMove.ToAsync(_machine, _program.Start).ConfigureAwait(false) is { Ends: true } lost) return lost;
        if (await _way.CutAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        if (_program.Finish is { } finish && await RapidMove.ToAsync(_machine, finish).ConfigureAwait(false) is { Ends: true } unfinished) return unfinished;
        return new JobStep(JobOutcome.Complete, Wording.Get("Job.DoneSegments", _ledger.Executed), null);
    }

    /// <summary>Whether a rapid would leave the controller's 32 bits.</summary>
    private bool IsTooFar => !_program.Strokes.All(stroke => _machine.ControllerFrame.Holds(stroke.Start)) || !_machine.ControllerFrame.Holds(_program.Start) || !_machine.ControllerFrame.Holds(_program.Finish ?? _program.Start);

    /// <summary>Tool off, stop, our threads halted, at rest; after a complete job only the threads are left to stop. Tried over a lost link too, because the other handle may still work.</summary>
    private async Task<(JobStep Step, StandstillReport? Standstill)> BringToRestAsync(JobStep step)
    {
        if (!_touched) return (step, null);
        try
        {
            var standstill = await _stopper.FinishAsync(_options.PollInterval, CancellationToken.None).ConfigureAwait(false);
            if (step.Ends) await _way.StoppedAsync(standstill.SegmentCounter).ConfigureAwait(false);
            return (step, standstill);
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

    /// <summary>What was last known. After the link is lost the controller continues unseen: with its buffer, or a program with all its strokes, until the watchdog trips.</summary>
    private string LastWord => _machine.Known is { } known
        ? Wording.Get("Job.LastWordControllerWith", known.Position.X, known.Position.Y, _ledger.Executed)
        : "";

    /// <summary>Restores the found program, speeds and motors; the machine is at rest and our threads are halted.</summary>
    private async Task<IReadOnlyList<string>> LeaveAsFoundAsync()
    {
        if (!_touched) return [];
        try
        {
            await _machine.EndWatchAsync().ConfigureAwait(false);
            var refused = await _memory.GiveBackAsync(CancellationToken.None).ConfigureAwait(false);
            var settings = await _session.RestoreAsync(CancellationToken.None).ConfigureAwait(false);
            if (refused is not null) return [refused.Explain(), .. settings];
            if (settings.Count == 0) _found.GivenBack();
            return [.. _found.Lost, .. settings];
        }
        catch (Exception unwritten) when (unwritten is IOException or UnauthorizedAccessException)
        {
            return [Wording.Get("Job.JournalEarlierRunCould", unwritten.Message)];
        }
        catch (ControllerException failure)
        {
            return [Wording.Get("Job.ControllerCouldNotLeft", failure.Message)];
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
        FinalPosition = standstill is { } rest ? new CountsPoint(rest.X, rest.Y) : _machine.Known?.Position,
        FrameOrigin = _machine.FrameTaken,
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
