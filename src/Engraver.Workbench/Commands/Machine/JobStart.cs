using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>What comes before and after a job on whatever machine.</summary>
internal static class JobStart
{
    /// <summary>The job with a motion program; the operator must agree when the drawing has errors.</summary>
    /// <exception cref="CommandException">There is nothing to cut, or the operator does not agree.</exception>
    public static async Task<PreparedJob> PrepareAsync(CommandContext context, JobMode mode)
    {
        var job = JobPreparation.Prepare(context.Drawing, context.Document.Current.Settings, JobPlan.StyleOf(mode));
        FindingMessages.Say(context, job.Drawing.FileName, job.Diagnostics, Severity.Warning);
        if (job.Motion.Program is not { SegmentCount: > 0 }) throw new CommandException(CommandFailure.Drawing, $"{job.WithoutProgram}.");
        var hasErrors = job.Diagnostics.Any(found => found.Severity == Severity.Error);
        if (hasErrors && !await context.ConfirmAsync(Wording.Get("Machine.DrawingHasErrorsGo")).ConfigureAwait(false)) throw new CommandException(CommandFailure.Drawing, Wording.Get("JobStart.NotStartedDrawingHas"));
        return job;
    }

    public static MachineRunOptions Options(CommandContext context, PreparedJob job, ControllerAddress address, JobMode mode, bool dryRun) =>
        new(address, mode)
        {
            JournalPath = context.NewRunJournal(job.Drawing.FileName),
            DryRun = dryRun,
            Told = finding => FindingMessages.Say(context, job.Drawing.FileName, [finding], Severity.Warning),
        };

    /// <summary>Says how it went.</summary>
    /// <exception cref="CommandException">It did not go to the end.</exception>
    public static void Conclude(CommandContext context, PreparedJob job, MachineRunReport report)
    {
        if (report.Placement?.Refusal is { } unplaced)
        {
            FindingMessages.Say(context, job.Drawing.FileName, [unplaced], Severity.Error);
            throw new CommandException(CommandFailure.Refused, Wording.Get("JobStart.NotPlaced"));
        }

        context.Say(RunText.Sentence(job, report), MessageKind.Result);
        foreach (var left in report.Result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (report.Result.Outcome != JobOutcome.Complete) throw Failure(report.Result);
    }

    /// <summary>What did not go to the end.</summary>
    public static CommandException Failure(JobResult result) =>
        new(result.Outcome switch { JobOutcome.Stopped => CommandFailure.Stopped, JobOutcome.Refused => CommandFailure.Refused, JobOutcome.Deviated => CommandFailure.Drawing, _ => CommandFailure.LinkLost }, result.Sentence);
}
