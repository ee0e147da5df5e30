using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>One job on one machine: connects, runs, judges, leaves.</summary>
public static class MachineRun
{
    /// <param name="job">Prepared in the style of the mode, with a motion program.</param>
    /// <param name="program">Of <paramref name="job"/>, made fit for the link (<see cref="JobPlan.FitToLink"/>).</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link never came up. A link lost later is an outcome, not an exception.</exception>
    /// <exception cref="IOException">The journal or the trace cannot be written.</exception>
    public static async Task<MachineRunReport> RunAsync(
        PreparedJob job, MotionProgram program, MachineRunOptions options, TimeProvider time, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        await using var connection = MachineConnection.To(options.Address, time);
        return await RunAsync(job, program, connection, options, time, progress, stop).ConfigureAwait(false);
    }

    /// <summary>The same on a machine that stays connected afterwards.</summary>
    /// <param name="connection">Where to; the address of the options is not looked at.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link never came up.</exception>
    /// <exception cref="IOException">The journal or the trace cannot be written.</exception>
    public static async Task<MachineRunReport> RunAsync(
        PreparedJob job, MotionProgram program, MachineConnection connection, MachineRunOptions options, TimeProvider time, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        using var clock = connection.TakeClock();
        var trace = options.TracePath is { } path ? clock.TraceTo(await OpenAsync(path, stop).ConfigureAwait(false), wall: time) : null;
        MachineRunReport report;
        try
        {
            report = await InSessionAsync(job, program, connection, options, trace, clock, progress, stop).ConfigureAwait(false);
        }
        finally
        {
            if (trace is not null) await trace.CloseAsync(stop).ConfigureAwait(false); // behind the session: until its links are closed something may be heard
        }

        return report with { TraceFailure = trace?.Failure };
    }

    /// <summary>A named pipe opens when somebody reads at its other end, which the operator's stop does not wait for.</summary>
    private static Task<StreamWriter> OpenAsync(string path, CancellationToken stop) =>
        Task.Factory.StartNew(() => new StreamWriter(path), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default).WaitAsync(stop);

    private static async Task<MachineRunReport> InSessionAsync(
        PreparedJob job, MotionProgram program, MachineConnection connection, MachineRunOptions options, MachineTrace? trace, MachineClock clock, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        var listener = options.DryRun || connection.Simulator is null ? null : new RecordListener(job.Settings.Machine, RunJudge.JudgeOf(job));
        using var listening = listener is null ? null : connection.Simulator?.Record.Subscribe(listener); // what earlier jobs on the same simulated controller cut does not count for this one
        var judgement = RunJudgement.Unknown;
        var jobOptions = new JobOptions
        {
            Judge = ended => RunVerdict.Judge(job, program, ended, judgement = Judge(job, program, ended, listener, options.DryRun)),
            Mode = options.Mode,
            JournalPath = options.JournalPath,
            Address = connection.Description,
            DrawingName = job.Drawing.FileName,
            DryRun = options.DryRun,
            SourceOf = job.Drawing.SourceOf,
            Begins = header => Begin(job, connection.Description, options, header),
            FrameTaken = frame => listener?.Start(frame.X, frame.Y),
            KeepsPolledTrace = connection.Simulator is null,
        };
        await using var machine = await clock.ShakeHandsAsync(connection, trace, stop).ConfigureAwait(false);
        var result = await machine.RunAsync(program, jobOptions, progress, stop).ConfigureAwait(false);
        return new MachineRunReport(result, judgement, machine.Identity.Model, machine.PlannedSeconds(program, options.Mode));
    }

    private static void Begin(PreparedJob job, string controller, MachineRunOptions options, JournalHeader header)
    {
        if (options.Starts is not { } starts) return;
        foreach (var finding in StartPlace.Begin(starts, controller, job, header)) options.Told?.Invoke(finding);
    }

    private static RunJudgement Judge(PreparedJob job, MotionProgram program, JobResult result, RecordListener? listener, bool dryRun)
    {
        if (dryRun || result.FrameOrigin is null) return RunJudgement.Unknown;
        return listener is null ? RunJudge.ByPolling(job, program, result) : RunJudge.ByRecord(listener.Verdicts()[0]);
    }
}

/// <summary>How a run ended and what it is worth.</summary>
/// <param name="Controller">The model as the controller names itself.</param>
/// <param name="PlannedSeconds">By the trapezoids the controller runs and the commands exchanged at standstills over this link.</param>
public sealed record MachineRunReport(JobResult Result, RunJudgement Judgement, string Controller, double PlannedSeconds)
{
    /// <summary>Why the trace of the wire ended before the job did; null when it is whole, or none was wanted.</summary>
    public string? TraceFailure { get; init; }
}
