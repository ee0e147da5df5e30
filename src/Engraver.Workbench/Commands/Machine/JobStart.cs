using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Preparation and completion of a job, on a real or a simulated machine.</summary>
internal static class JobStart
{
    /// <summary>The job with a motion program; the operator must confirm if the drawing has errors.</summary>
    /// <exception cref="CommandException">There is nothing to cut, or the operator declined.</exception>
    public static Task<PreparedJob> PrepareAsync(CommandContext context, ExecutionStrategy strategy) => PrepareAsync(context, strategy, PlateStart.Take(context));

    /// <summary>The same, of the drawing or of the trajectories of the document.</summary>
    /// <exception cref="CommandException">There is nothing to cut, or the operator declined.</exception>
    public static Task<PreparedJob> PrepareAsync(CommandContext context, ExecutionStrategy strategy, bool runsTrajectories) =>
        runsTrajectories ? CheckAsync(context, PrepareTrajectories(context, strategy)) : PrepareAsync(context, strategy);

    /// <summary>The same, of a plate of the drawing.</summary>
    /// <param name="plate">Null for a drawing without plates.</param>
    /// <exception cref="CommandException">There is nothing to cut, or the operator declined.</exception>
    public static Task<PreparedJob> PrepareAsync(CommandContext context, ExecutionStrategy strategy, Plate? plate) =>
        CheckAsync(context, PlateJob.Prepare(context.Drawing, context.Document.Current.Settings, strategy.Style, plate));

    private static async Task<PreparedJob> CheckAsync(CommandContext context, PreparedJob job)
    {
        FindingMessages.Write(context, job.Drawing.FileName, job.Diagnostics, Severity.Warning);
        if (job.Motion.Program is not { SegmentCount: > 0 }) throw new CommandException(CommandFailure.Drawing, $"{job.NoProgramReason}.");
        var hasErrors = job.Diagnostics.Any(found => found.Severity == Severity.Error);
        if (hasErrors && !await context.ConfirmAsync(Wording.Get("Machine.ContinueWithErrors")).ConfigureAwait(false)) throw new CommandException(CommandFailure.Drawing, Wording.Get("JobStart.DrawingHasErrors"));
        return job;
    }

    /// <summary>The trajectories of the document as a job; reports their number and error bound.</summary>
    /// <exception cref="CommandException">There are none.</exception>
    public static PreparedJob PrepareTrajectories(CommandContext context, ExecutionStrategy strategy)
    {
        var followed = TrajectoryJob.Prepare(context.Drawing, context.Document.Current.Settings, TrajectorySelection.All(context), strategy.Style);
        context.WriteMessage(Wording.Get("JobStart.Trajectories", CountText.Format(followed.Trajectories.Count, "Trajectory"), DisplayPrecision.FormatErrorBound(followed.Bound)));
        return followed.Job;
    }

    public static MachineRunOptions Options(CommandContext context, PreparedJob job, ControllerAddress address, ExecutionStrategy strategy, bool dryRun) =>
        job.Settings is { Finish: FinishPlace.Park, Machine.Park: null } ? throw new CommandException(CommandFailure.Usage, Wording.Get("CncFinish.NoParkPosition")) : new(address, strategy)
        {
            Finish = job.Settings.Finish,
            JournalPath = context.NewRunJournal(job.Drawing.FileName),
            DryRun = dryRun,
            Resume = job.Trajectories is null ? context.Machine.Runs.Part?.Request : null,
            FindingReported = finding => FindingMessages.Write(context, job.Drawing.FileName, [finding], Severity.Warning),
        };

    /// <summary>Runs a job, adds it to the history and reports the result.</summary>
    /// <param name="checks">The start checks with which it was armed; null if there were none.</param>
    /// <param name="run">Runs the job with the given options.</param>
    /// <exception cref="CommandException">The job did not complete.</exception>
    /// <exception cref="ControllerException">The link could not be established.</exception>
    public static async Task RunAsync(CommandContext context, PreparedJob job, ArmingChecklist? checks, Func<Func<MachineRunOptions, MachineRunOptions>, Task<MachineRunReport>> run, bool simulated)
    {
        var (begun, taken, open, ended) = (context.Time.GetUtcNow(), default(MachineRunOptions), default(PendingRun), default(MachineRunReport));
        using var turn = simulated ? null : PlateStart.Turn(context, job);
        try
        {
            var report = await run(options =>
            {
                open = context.BeginRun(HistoryEntry.OfStarted(job, options, begun, simulated));
                return taken = turn is null || options.DryRun ? options : options with { Starting = stop => turn.StartAsync(job.Drawing.FileName, options.JournalPath, stop) };
            }).ConfigureAwait(false);
            ended = report;
            open?.End(HistoryEntry.OfRun(job, taken!, report, begun, simulated, checks));
            ReportResult(context, job, report);
        }
        catch (ControllerException lost) when (open is not null)
        {
            open.End(HistoryEntry.OfLost(job, taken!, lost.Message, begun));
            throw;
        }
        catch (OperationCanceledException)
        {
            context.WriteMessage(Wording.Get("JobStart.StoppedBeforeMotion"), MessageKind.Warning); // A job that has moved ends with a report.
            throw;
        }
        finally
        {
            if (turn is not null && taken is { DryRun: false }) await PlateStart.EndAsync(context, turn, job, ended).ConfigureAwait(false);
            open?.Dispose();
        }
    }

    /// <summary>Reports the result of the job.</summary>
    /// <exception cref="CommandException">The job did not complete.</exception>
    public static void ReportResult(CommandContext context, PreparedJob job, MachineRunReport report)
    {
        if (report.ResumeRefusal is { } unresumed)
        {
            FindingMessages.Write(context, job.Drawing.FileName, [unresumed], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.NotResumed"));
        }

        if (report.Placement?.Refusal is { } unplaced)
        {
            FindingMessages.Write(context, job.Drawing.FileName, [unplaced], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.WorkOriginUnknown"));
        }

        if (report.StartRefusal is { } unstarted)
        {
            FindingMessages.Write(context, job.Drawing.FileName, [unstarted], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.NotStarted"));
        }

        context.WriteMessage(RunText.Sentence(job, report, SettingWording.AtCommandLine), MessageKind.Result);
        foreach (var left in report.Result.NotRestored) context.WriteMessage(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (SectionBreak.Of(job, report) is { } at) context.WriteMessage(Wording.Get(at.IsToolChange ? "JobStart.ToolChange" : "JobStart.OperatorStop", at.NextText), MessageKind.Warning);
        else if (report.Result.Outcome != JobOutcome.Complete) throw Failure(report.Result);
    }

    /// <summary>Reports which part will be cut if it is not the whole drawing.</summary>
    /// <exception cref="CommandException">It was started with another strategy.</exception>
    public static void WritePart(CommandContext context, PreparedJob job, ExecutionStrategy strategy)
    {
        if (context.Machine.Runs.Part is not { } part || job.Trajectories is not null || job.Motion.Program is not { } program) return;
        if (part.Strategy is { } begun && begun != strategy) throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.PartOtherMode", begun.Keyword, strategy.Keyword));
        var place = part.Request.Journal is null ? ResumePoint.ToStroke(program, part.Request.Stroke) : part.Shown;
        context.WriteMessage(Wording.Get("JobStart.Part", place.Segments, program.SegmentCount), MessageKind.Warning);
    }

    /// <summary>The failure of a job that did not complete.</summary>
    public static CommandException Failure(JobResult result) =>
        new(result.Outcome switch { JobOutcome.Stopped => CommandFailure.Stopped, JobOutcome.Refused => CommandFailure.Refused, JobOutcome.Deviated => CommandFailure.Drawing, _ => CommandFailure.LinkLost }, result.Message);
}
