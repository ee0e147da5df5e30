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
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>What comes before and after a job, on a real machine or a simulated one.</summary>
internal static class JobStart
{
    /// <summary>The job with a motion program; the operator must agree when the drawing has errors.</summary>
    /// <exception cref="CommandException">There is nothing to cut, or the operator does not agree.</exception>
    public static Task<PreparedJob> PrepareAsync(CommandContext context, JobMode mode) => PrepareAsync(context, mode, runsTrajectories: false);

    /// <summary>The same, of the drawing or of the trajectories of the document.</summary>
    /// <exception cref="CommandException">There is nothing to cut, or the operator does not agree.</exception>
    public static async Task<PreparedJob> PrepareAsync(CommandContext context, JobMode mode, bool runsTrajectories)
    {
        var job = runsTrajectories ? Followed(context, mode) : JobPreparation.Prepare(context.Drawing, context.Document.Current.Settings, JobPlan.StyleOf(mode));
        FindingMessages.Say(context, job.Drawing.FileName, job.Diagnostics, Severity.Warning);
        if (job.Motion.Program is not { SegmentCount: > 0 }) throw new CommandException(CommandFailure.Drawing, $"{job.WithoutProgram}.");
        var hasErrors = job.Diagnostics.Any(found => found.Severity == Severity.Error);
        if (hasErrors && !await context.ConfirmAsync(Wording.Get("Machine.ContinueWithErrors")).ConfigureAwait(false)) throw new CommandException(CommandFailure.Drawing, Wording.Get("JobStart.DrawingHasErrors"));
        return job;
    }

    /// <summary>The trajectories of the document as a job; says what it is.</summary>
    /// <exception cref="CommandException">There are none.</exception>
    public static PreparedJob Followed(CommandContext context, JobMode mode)
    {
        var followed = TrajectoryJob.Prepare(context.Drawing, context.Document.Current.Settings, TrajectoryPick.All(context), JobPlan.StyleOf(mode));
        context.Say(Wording.Get("JobStart.Trajectories", CountText.Format(followed.Trajectories.Count, "Trajectory"), Figures.Bound(followed.Bound)));
        return followed.Job;
    }

    public static MachineRunOptions Options(CommandContext context, PreparedJob job, ControllerAddress address, JobMode mode, bool dryRun) =>
        job.Settings is { Finish: FinishPlace.Park, Machine.Park: null } ? throw new CommandException(CommandFailure.Usage, Wording.Get("CncFinish.NoParkPosition")) : new(address, mode)
        {
            Finish = job.Settings.Finish,
            JournalPath = context.NewRunJournal(job.Drawing.FileName),
            DryRun = dryRun,
            Resume = job.Followed is null ? context.Machine.Runs.Part?.Request : null,
            Told = finding => FindingMessages.Say(context, job.Drawing.FileName, [finding], Severity.Warning),
        };

    /// <summary>Runs a job, writes it into the history, and tells the operator how it ended.</summary>
    /// <param name="checks">The list that it was armed by; null where there was none.</param>
    /// <param name="run">Runs it with the options that it hands on.</param>
    /// <exception cref="CommandException">The job did not complete.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public static async Task RunAsync(CommandContext context, PreparedJob job, ArmingChecklist? checks, Func<Func<MachineRunOptions, MachineRunOptions>, Task<MachineRunReport>> run, bool simulated)
    {
        var (begun, taken, open) = (context.Time.GetUtcNow(), default(MachineRunOptions), default(OpenJob));
        try
        {
            var report = await run(options =>
            {
                open = context.Begin(HistoryEntry.OfBegun(job, options, begun, simulated));
                return taken = options;
            }).ConfigureAwait(false);
            open?.End(HistoryEntry.OfRun(job, taken!, report, begun, simulated, checks));
            Conclude(context, job, report);
        }
        catch (ControllerException lost) when (open is not null)
        {
            open.End(HistoryEntry.OfLost(job, taken!, lost.Message, begun));
            throw;
        }
        catch (OperationCanceledException)
        {
            context.Say(Wording.Get("JobStart.StoppedBeforeMotion"), MessageKind.Warning); // what has moved ends with a report
            throw;
        }
        finally
        {
            open?.Dispose();
        }
    }

    /// <summary>Tells the operator how the job ended.</summary>
    /// <exception cref="CommandException">The job did not complete.</exception>
    public static void Conclude(CommandContext context, PreparedJob job, MachineRunReport report)
    {
        if (report.ResumeRefusal is { } unresumed)
        {
            FindingMessages.Say(context, job.Drawing.FileName, [unresumed], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.NotResumed"));
        }

        if (report.Placement?.Refusal is { } unplaced)
        {
            FindingMessages.Say(context, job.Drawing.FileName, [unplaced], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.WorkOriginUnknown"));
        }

        context.Say(RunText.Sentence(job, report, SettingWording.AtCommandLine), MessageKind.Result);
        foreach (var left in report.Result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (report.Result.Outcome != JobOutcome.Complete) throw Failure(report.Result);
    }

    /// <summary>Says what will be cut, where it is not the whole drawing.</summary>
    /// <exception cref="CommandException">It was begun in another mode.</exception>
    public static void SayPart(CommandContext context, PreparedJob job, JobMode mode)
    {
        if (context.Machine.Runs.Part is not { } part || job.Followed is not null || job.Motion.Program is not { } program) return;
        if (part.Mode is { } begun && begun != mode) throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.PartOtherMode", begun, mode));
        var place = part.Request.Journal is null ? JobBeginning.ToStroke(program, part.Request.Stroke) : part.Shown;
        context.Say(Wording.Get("JobStart.Part", place.Segments, program.SegmentCount), MessageKind.Warning);
    }

    /// <summary>The failure of a job that did not complete.</summary>
    public static CommandException Failure(JobResult result) =>
        new(result.Outcome switch { JobOutcome.Stopped => CommandFailure.Stopped, JobOutcome.Refused => CommandFailure.Refused, JobOutcome.Deviated => CommandFailure.Drawing, _ => CommandFailure.LinkLost }, result.Sentence);
}
