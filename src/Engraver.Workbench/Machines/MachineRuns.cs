using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Machines;

/// <summary>The jobs of a machine session: what START would run, the job under way, the last one and its trace.</summary>
public sealed class MachineRuns
{
    private readonly ConnectedMachine _machine;
    private readonly MotionInterlock _interlock;
    private readonly OperatorControls _controls;
    private readonly MachineStatusModel _status;
    private readonly TimeProvider _time;

    internal MachineRuns(ConnectedMachine machine, MotionInterlock interlock, OperatorControls controls, MachineStatusModel status, TimeProvider time) =>
        (_machine, _interlock, _controls, _status, _time) = (machine, interlock, controls, status, time);

    /// <summary>The last progress of the job under way or just ended; null before the first.</summary>
    public JobProgress? Progress { get; private set; }

    public MachineRunReport? LastRun { get; private set; }

    /// <summary>The job whose progress the status shows, under way or ended; null before the first and after <see cref="DismissJob"/>.</summary>
    public PreparedJob? ShownJob { get; private set; }

    /// <summary>What START would cut where it is not the whole drawing; null for all of it.</summary>
    public JobPart? Part { get; private set; }

    /// <summary>Where the machine was in the last run of which that is known, real or simulated; null before the first.</summary>
    public RecordedRun? Recorded { get; private set; }

    /// <summary>Chooses what START cuts. Disarms.</summary>
    /// <param name="part">Null for the whole drawing.</param>
    public void ChoosePart(JobPart? part)
    {
        if (Part == part) return;
        _status.Arming.Disarm();
        Part = part;
        _status.RaiseChanged();
    }

    /// <summary>Forgets the job that ended last, so that its progress is not shown with another drawing. Does nothing while a job runs.</summary>
    public void DismissJob()
    {
        if (_interlock.IsRunning) return;
        ShownJob = null;
        _status.DismissJob();
        _status.RaiseChanged();
    }

    /// <summary>Arms a job: START works for a minute, or until the machine, the drawing or a setting changes.</summary>
    /// <exception cref="InvalidOperationException">Something on the checklist has not passed.</exception>
    public ArmedJob Arm(PreparedJob job, ExecutionStrategy strategy, bool dryRun, ArmingChecklist checklist)
    {
        ArgumentNullException.ThrowIfNull(checklist);
        if (!checklist.Passed || !_status.Status.State.IsReady()) throw new InvalidOperationException("What was not checked cannot be armed.");
        DismissJob();
        return _status.Arming.Arm(job, strategy, dryRun, checklist);
    }

    /// <summary>Runs a job on the connected controller. One at a time.</summary>
    /// <param name="options">Gives the options of the run for the address of the controller.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<MachineRunReport> RunAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(options);
        var free = await _machine.FreeAsync().ConfigureAwait(false);
        var address = _machine.Watched.Address!;
        MachineRunOptions given = null!;
        LiveTrace? live = null;
        return await _machine.UseAsync(free, Begin, RunOnAsync, cancellation).ConfigureAwait(false);

        void Begin()
        {
            given = options(address);
            Progress = null;
            ShownJob = job;
            Recorded = null;
            live = LiveTrace.Of(job, given.DryRun);
            _status.JobStarted(given.DryRun);
        }

        async Task<MachineRunReport> RunOnAsync(MachineConnection connection, CancellationToken stop)
        {
            try
            {
                var full = given with { Lease = _machine.Lease, Control = _controls.Begin(), FrameFound = frame => _status.SetFrame(frame) };
                var report = await MachineRun.RunAsync(job, program, connection, full, _time, Listener(_status, live), stop).ConfigureAwait(false);
                Recorded = report.Trace is { } trace ? new RecordedRun(job, trace) : Recorded;
                _status.JobEnded(report.Result);
                if (report.Result.Outcome == JobOutcome.Complete && !given.DryRun) Part = null;
                if (SectionBreak.Of(job, report) is { } at) Part = RestOf(job, given, report, at);
                else if (report.Result.FrameOrigin is not null && !given.DryRun && Part is { Break: not null } begun) Part = begun with { Break = null }; // it has moved: it is resumed by its own journal
                return LastRun = report;
            }
            finally
            {
                _controls.End();
            }
        }
    }

    /// <summary>Runs a job on a simulated controller of its own, as fast as it can be computed; a connected machine is left alone.</summary>
    /// <exception cref="InvalidOperationException">A job runs already.</exception>
    public async Task<MachineRunReport> SimulateAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(options);
        await _interlock.FreeAsync().ConfigureAwait(false);
        var address = new SimulatedAddress(double.PositiveInfinity);
        var report = await _interlock.RunAsync(
            async stop =>
            {
                Progress = null;
                return LastRun = await SectionedRun.RunAsync(
                    options(address),
                    program.Profile.Scale,
                    RunAsync,
                    (_, refused) => Task.FromResult(refused is null)).ConfigureAwait(false);

                // Each section finds its machine at 0, where a simulated one has its origin.
                async Task<MachineRunReport> RunAsync(MachineRunOptions section)
                {
                    await using var connection = _machine.Families.At(address, program.Profile).Connect(address, _time, false, null);
                    return await MachineRun.RunAsync(job, program, connection, section, _time, Listener(null), stop).ConfigureAwait(false);
                }
            },
            cancellation).ConfigureAwait(false);
        Recorded = report.Trace is { } trace ? new RecordedRun(job, trace) : Recorded;
        _status.RaiseChanged();
        return report;
    }

    /// <summary>Moves once around a job with the tool off, at the active work origin, and disarms. It is stopped as a job is; what the last job cut stays
    /// known.</summary>
    /// <param name="frame">Made of the job (<see cref="JobFrame"/>).</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    /// <returns>How it ended; the diagnostic states why the job has no place.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> FrameAsync(MotionProgram frame, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(frame);
        var free = await _machine.FreeAsync().ConfigureAwait(false);
        var fitted = JobPlan.FitFrameToLink(frame, _machine.Watched.Address!);
        return await _machine.UseAsync(
            free,
            () => _status.MoveStarted(Wording.Get("MachineSession.Frame")),
            async (connection, stop) =>
            {
                var result = await MachineFraming.RunAsync(connection, _machine.Lease!, fitted, journal, _status.SetFrame, new JobListener(_status.MoveProgressed), stop).ConfigureAwait(false);
                if (result.FrameOrigin is not null) _status.MoveEnded(result);
                return result;
            },
            cancellation).ConfigureAwait(false);
    }

    /// <summary>Where an interrupted job resumes, by its journal and by what the connected controller has stored.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<ResumePosition> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation)
    {
        var watch = await _machine.IdleAsync().ConfigureAwait(false);
        return await watch.FindResumeAsync(program, strategy, journal, cancellation).ConfigureAwait(false);
    }

    /// <summary>Shows a stored run, or none; the next run replaces it.</summary>
    /// <param name="run">Null for none.</param>
    /// <exception cref="InvalidOperationException">A job runs, whose own trace is shown.</exception>
    public void ShowRun(RecordedRun? run)
    {
        if (_interlock.IsRunning) throw new InvalidOperationException("A job runs.");
        Recorded = run;
        _status.RaiseChanged();
    }

    /// <summary>What is left after a change of the tool or a stop.</summary>
    private static JobPart RestOf(PreparedJob job, MachineRunOptions options, MachineRunReport ended, SectionBreak at) =>
        new(new ResumeRequest { Journal = options.JournalPath }, ended.Result.Place, options.Strategy, job.DocumentDrawing, job.Settings) { Plate = job.Plate, Break = at };

    /// <summary>The drawing's zero is elsewhere now: the last job was cut at another place, and so was what START should cut of it. Between two sections only
    /// the height is set again; another place is refused when the rest is started.</summary>
    internal void ForgetPlace()
    {
        if (Part is not { Break: not null }) Part = null;
        DismissJob();
    }

    /// <summary>The height of the work was set: with the tool of the next section, if the job is between two.</summary>
    internal void NoteHeight()
    {
        if (Part is not { Break: { } at } rest) return;
        Part = rest with { Break = at with { IsHeightSet = true } };
        _status.RaiseChanged();
    }

    /// <param name="status">Null for a job that does not run on the connected machine.</param>
    /// <param name="live">Null where the positions are not collected during the run.</param>
    private JobListener Listener(MachineStatusModel? status, LiveTrace? live = null) => new(value =>
    {
        Progress = value;
        if (live?.Add(value) is { } soFar) Recorded = soFar;
        status?.JobProgressed(value);
        _status.RaiseChanged();
    });
}
