using Engraver.Galil.Jobs;
using Engraver.Galil.Programs;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines;

/// <summary>One job on one machine: connects, runs, judges, leaves.</summary>
public static class MachineRun
{
    /// <param name="job">Prepared in the style of the mode, with a motion program.</param>
    /// <exception cref="Galil.Protocol.ControllerException">The link never came up. A link lost later is an outcome, not an exception.</exception>
    /// <exception cref="IOException">The journal or the trace cannot be written.</exception>
    public static async Task<MachineRunReport> RunAsync(
        PreparedJob job, MotionProgram program, MachineRunOptions options, TimeProvider time, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        await using var connection = MachineConnection.To(options.Address, time);
        await using var traceFile = options.TracePath is { } path ? new StreamWriter(path) : null;
        var sessionOptions = new SessionOptions { Trace = traceFile is null ? null : new WireTrace(traceFile, time) };
        var jobOptions = new JobOptions
        {
            Mode = options.Mode,
            JournalPath = options.JournalPath,
            DrawingName = job.Drawing.FileName,
            DryRun = options.DryRun,
            SourceOf = job.Drawing.SourceOf,
        };
        await using var session = await ControllerSession.OpenAsync(connection.OpenLinkAsync, sessionOptions, time, stop).ConfigureAwait(false);
        var result = await JobRunner.RunAsync(program, session, jobOptions, progress, stop).ConfigureAwait(false);
        return new MachineRunReport(result, Judge(job, program, result, connection, options.DryRun), session.Identity.Model, MotionTime.Estimate(program));
    }

    private static RunJudgement Judge(PreparedJob job, MotionProgram program, JobResult result, MachineConnection connection, bool dryRun)
    {
        if (dryRun || result.FrameOrigin is not { } origin) return RunJudgement.Unknown;
        return connection.Simulator is { } simulator
            ? RunJudge.ByRecord(job, simulator.Record.Snapshot(), origin.X, origin.Y)
            : RunJudge.ByPolling(job, program, result);
    }
}
