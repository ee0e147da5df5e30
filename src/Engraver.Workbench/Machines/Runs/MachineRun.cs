using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Verification;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Runs one job on one machine: connects, runs, judges, disconnects. A job of several sections ends with the next one of them
/// (<see cref="SectionedRun"/>).</summary>
public static class MachineRun
{
    /// <param name="job">Prepared in the style of the mode, with a motion program.</param>
    /// <param name="program">Program of <paramref name="job"/> with feeds limited to the link (<see cref="JobPlan.FitToLink"/>).</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link could not be established. A link lost later is an outcome, not an
    /// exception.</exception>
    /// <exception cref="IOException">The journal or the trace cannot be written.</exception>
    public static async Task<MachineRunReport> RunAsync(
        PreparedJob job, MotionProgram program, MachineRunOptions options, TimeProvider time, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(options);
        await using var connection = MachineFamilies.Standard.At(options.Address, program.Profile).Connect(options.Address, time, false, null);
        return await RunAsync(job, program, connection, options, time, progress, stop).ConfigureAwait(false);
    }

    /// <summary>The same on a machine that stays connected afterwards.</summary>
    /// <param name="connection">Connection to the machine; the address in the options is ignored.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link could not be established.</exception>
    /// <exception cref="IOException">The journal or the trace cannot be written.</exception>
    public static async Task<MachineRunReport> RunAsync(
        PreparedJob job, MotionProgram program, MachineConnection connection, MachineRunOptions options, TimeProvider time, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        using var clock = connection.CreateClock();
        var trace = options.TracePath is { } path ? clock.TraceTo(await OpenAsync(path, stop).ConfigureAwait(false), wall: time) : null;
        var (kept, unkept) = ConversationFile.Create(options.JournalPath);
        var conversation = kept is null ? null : clock.ConversationTo(kept, wall: time);
        MachineRunReport report;
        try
        {
            report = await InSessionAsync(job, program, connection, options, trace, conversation, clock, progress, stop).ConfigureAwait(false);
        }
        finally
        {
            if (trace is not null) await trace.CloseAsync(stop).ConfigureAwait(false); // After the session: data may arrive until its links are closed.
            if (conversation is not null) await conversation.CloseAsync(stop).ConfigureAwait(false);
        }

        if ((unkept ?? conversation?.Failure) is { } failure) options.FindingReported?.Invoke(PreparationRules.ConversationNotKept.At(default, failure));
        return report with { TraceFailure = trace?.Failure };
    }

    /// <summary>Opening a named pipe blocks until it has a reader; the operator's stop does not wait for that.</summary>
    private static Task<StreamWriter> OpenAsync(string path, CancellationToken stop) =>
        Task.Factory.StartNew(() => new StreamWriter(path), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default).WaitAsync(stop);

    private static async Task<MachineRunReport> InSessionAsync(
        PreparedJob job, MotionProgram program, MachineConnection connection, MachineRunOptions options, MachineTrace? trace, MachineConversation? conversation, MachineClock clock, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        await using var machine = await clock.HandshakeAsync(connection, trace, conversation, stop).ConfigureAwait(false);
        try
        {
            return await OnMachineAsync(job, program, machine, connection, options, clock, progress, stop).ConfigureAwait(false);
        }
        catch (MachineUnavailableException refused)
        {
            return new MachineRunReport(JobResult.NotStarted(program.Strokes.Count, refused.Message), RunJudgement.Unknown, machine.Identity.Model, machine.PlannedSeconds(program, options.Strategy));
        }
    }

    /// <exception cref="MachineInUseException">Another host uses the machine; nothing was moved.</exception>
    /// <exception cref="MachineMemoryException">The work origin cannot be read or written; nothing was moved.</exception>
    private static async Task<MachineRunReport> OnMachineAsync(
        PreparedJob job, MotionProgram program, IMachineConnection machine, MachineConnection connection, MachineRunOptions options, MachineClock clock, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        if (job.RunRefusals is [var unable, ..]) return MachineRunReport.NotBegun(unable, program, machine.Identity.Model, 0.0);
        using var taken = options.Lease is null ? options.Memories.Acquire(connection.Description, machine.Identity, await machine.ReadPositionAsync(program.Profile.Axes, stop).ConfigureAwait(false), options.LeaseOwner) : null;
        if (taken is { IsPersistent: false } && connection.Simulator is not null)
        {
            taken.AssumeHomed(program.Profile);
            taken.AssumeOrigins(options.NamedOrigins, program.Profile.Axes.Z is not null);
        }

        var link = await machine.FitToLinkAsync(program, options.Strategy, job.Drawing.SourceOf, stop).ConfigureAwait(false);
        foreach (var finding in link.Diagnostics) options.FindingReported?.Invoke(finding);
        program = link.Program;
        var beginning = await ResumePoint.FindAsync(machine, job, program, options, (options.Lease ?? taken!).Memory, stop).ConfigureAwait(false);
        if (beginning.Refusal is { } refused) return MachineRunReport.NotResumed(refused, program, machine.Identity.Model);
        var section = options.DryRun ? null : JobSection.At(job, program, beginning.Place); // a dry run needs no other tool
        var placement = await JobPlacement.FindAsync(machine, options.Lease ?? taken!, program, options.DryRun, beginning.Origin, section is { IsLast: false } && options.Finish == FinishPlace.Stay ? FinishPlace.Origin : options.Finish, options.Following, clock.Time, stop).ConfigureAwait(false);
        var planned = machine.PlannedSeconds(beginning.RestOf(section?.UpToEnd(placement.Program) ?? placement.Program), options.Strategy);
        var unready = await RefusalAsync(placement, options.Lease ?? taken!, machine, connection, options, clock.Time, stop).ConfigureAwait(false);
        if (placement.Found.Frame is not { } frame) return MachineRunReport.NotPlaced(placement, machine.Identity.Model, planned);
        if (unready is not null) return new MachineRunReport(JobResult.NotStarted(placement.Program.Strokes.Count, Wording.Get("MachineRun.NotReady", unready)), RunJudgement.Unknown, machine.Identity.Model, planned);
        if (options.Starting is { } starting && await starting(stop).ConfigureAwait(false) is { } unstarted) return MachineRunReport.NotBegun(unstarted, placement.Program, machine.Identity.Model, planned);
        var judged = await RunPlacedAsync(job, section, placement, beginning, frame, machine, connection, options, progress, stop).ConfigureAwait(false);
        return new MachineRunReport(judged.Result, judged.Judgement, machine.Identity.Model, planned)
        {
            Placement = placement.Found,
            OpenLoop = placement.OpenLoop,
            Section = section,
            ToleranceMm = RunVerdict.Tolerance(job, placement.Program, judged.Judgement),
            Trace = judged.Trace,
            Lag = judged.Trace is { } trace && !options.DryRun ? RunLag.Of(placement.Program, trace) : null,
            IsDryRun = options.DryRun,
            ResumedFrom = options.Resume is null ? null : beginning.Place,
            Journal = options.JournalPath,
        };
    }

    /// <summary>Polls the machine and checks whether the job may start.</summary>
    /// <returns>Why not; null if it may, or without a check.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    private static async Task<string?> RefusalAsync(JobPlacement placement, MachineLease lease, IMachineConnection machine, MachineConnection connection, MachineRunOptions options, TimeProvider time, CancellationToken stop)
    {
        if (options.CheckStart is not { } mayStart) return null;
        var profile = placement.Program.Profile;
        var facts = new MachineFacts
        {
            Link = connection.Description,
            IsSimulation = connection.Simulator is not null,
            Identity = machine.Identity,
            Poll = await machine.ReadStatusAsync(profile.Axes, stop).ConfigureAwait(false),
            IsHomed = profile.HasHoming ? lease.IsHomed(profile) : null,
            HomingIsAssumed = lease.Memory.HomingIsAssumed,
            LastAnswerTime = time.GetUtcNow(),
        };
        return mayStart(facts.ToStatus(profile, armed: null), placement);
    }

    /// <param name="section">The strokes of one tool that are cut and judged; null for a job of one tool.</param>
    /// <param name="frame">Controller counts at the drawing's zero, used for the motion and for the comparison.</param>
    private static async Task<(JobResult Result, RunJudgement Judgement, RunTrace? Trace)> RunPlacedAsync(
        PreparedJob whole, JobSection? section, JobPlacement placement, ResumePoint beginning, CountsPoint frame, IMachineConnection machine, MachineConnection connection, MachineRunOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        var job = section?.JudgedOf(whole) ?? whole;
        var judge = options.DryRun || connection.Simulator is null ? null : RunJudge.JudgeOf(job);
        var operations = judge is null ? null : OperationJudge.Of(whole, section?.Tool, RunJudge.Tolerances(job), job.Settings.CuttingMachine.Height is not null);
        ITraceJudge[] judges = [.. new[] { judge, operations?.Judge }.OfType<ITraceJudge>()];
        foreach (var one in judges) beginning.FeedJudge(one, placement.Program, section);
        var listener = judge is null ? null : new RecordListener(job.Settings.CuttingMachine, judges) { Places = RunJudge.PlacesOf(job), Motors = RunJudge.MotorsOf(job) };
        using var listening = listener is null ? null : connection.Simulator?.Record.Subscribe(listener); // Cuts of earlier jobs on the same simulated controller do not count for this one.
        listener?.Start(frame.X, frame.Y, frame.Z);
        var polled = options.DryRun || connection.Simulator is not null ? null : new PolledJudge(job);
        var judgement = RunJudgement.Unknown;
        var jobOptions = new JobOptions
        {
            Judge = ended => RunVerdict.Judge(job, placement.Program, ended, judgement = Judge(section?.UpToEnd(placement.Program) ?? placement.Program, ended, listener, operations, polled)),
            Strategy = options.Strategy,
            JournalPath = options.JournalPath,
            Address = connection.Description,
            DrawingName = job.Drawing.FileName,
            Settings = JournalSettings.Of(whole),
            DryRun = options.DryRun,
            Control = options.Control,
            From = beginning.Place,
            Until = section is { IsLast: false } ? section.Until : null,
            SectionEnd = section is { IsLast: false } ? section.OutcomeIn(whole) : JobOutcome.ToolChange,
            ResumedJournal = options.Resume?.Journal,
            LeadIn = beginning.LeadIn,
            HeightOfCut = beginning.HeightOfCut,
            SourceOf = job.Drawing.SourceOf,
            Frame = frame,
            SoftLimits = placement.KnowsTravel ? TravelLimits.Of(placement.Program.Profile) : [],
            Polled = polled is null ? null : polled.Add,
            Warned = options.FindingReported,
            FollowedAxes = connection.Simulator is null ? string.Concat(placement.Program.Profile.Axes.Named.Where(named => !placement.OpenLoop.Contains(named.Name)).Select(named => named.Axis.Letter)) : "", // a stepper has no position error: its position is what was commanded
        };
        options.FrameFound?.Invoke(frame);
        if (machine.Identity.UntriedFamily is { } family) options.FindingReported?.Invoke(PreparationRules.FamilyUntried.At(default, machine.Identity.Model, family));
        if (placement.UnknownMotorTypes.Count > 0) options.FindingReported?.Invoke(PreparationRules.MotorUntold.At(default, string.Join(", ", placement.UnknownMotorTypes)));
        placement.NoteStart();
        var observer = new JobListener(told =>
        {
            listener?.SetConditions(RunJudge.ConditionsOf(told));
            polled?.SetConditions(RunJudge.ConditionsOf(told));
            progress?.Report(told);
        });
        var result = await machine.RunAsync(placement.Program, jobOptions, observer, stop).ConfigureAwait(false);
        if (placement.NoteEnd(result) is { } unkept) options.FindingReported?.Invoke(unkept);
        return (result, judgement, Recorded(result, listener, polled, options));
    }

    /// <summary>The trace that is saved beside the journal. A dry run cuts nothing and has no trace.</summary>
    private static RunTrace? Recorded(JobResult result, RecordListener? listener, PolledJudge? polled, MachineRunOptions options)
    {
        if (result.FrameOrigin is null || (listener?.Trace() ?? polled?.Trace()) is not { } trace) return null;
        if (TraceFile.Save(trace, options.JournalPath) is { } failure) options.FindingReported?.Invoke(PreparationRules.TraceNotKept.At(default, failure));
        return trace;
    }

    private static RunJudgement Judge(MotionProgram program, JobResult result, RecordListener? listener, OperationJudge? operations, PolledJudge? polled)
    {
        if (result.FrameOrigin is null) return RunJudgement.Unknown;
        return listener is not null ? RunJudge.ByRecord(listener.Verdicts()[0], listener.Motors) with { Operations = operations is null ? [] : listener.Between(operations.Measured) } : polled?.Judge(program, result) ?? RunJudgement.Unknown;
    }
}
