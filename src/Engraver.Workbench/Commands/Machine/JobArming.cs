using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>What is armed.</summary>
/// <param name="RunsTrajectories">The trajectories of the document instead of its drawing.</param>
internal sealed record ArmingMode(ExecutionStrategy Strategy, bool DryRun, bool RunsTrajectories);

/// <summary>The start checks of a job, each of which is reported, and its arming.</summary>
internal static class JobArming
{
    /// <exception cref="CommandException">A check has not passed, or the operator declined.</exception>
    public static async Task<ArmedJob> ArmAsync(CommandContext context, ArmingMode mode, CancellationToken cancellation)
    {
        if (mode is { DryRun: false, RunsTrajectories: false }) await PlateStart.DecideAsync(context).ConfigureAwait(false);
        var job = mode.RunsTrajectories ? JobStart.PrepareTrajectories(context, mode.Strategy) : await JobAsync(context, mode.Strategy, cancellation).ConfigureAwait(false);
        JobStart.WritePart(context, job, mode.Strategy);
        var hasErrors = job.Diagnostics.Any(found => found.Severity == Severity.Error);
        var accepted = hasErrors && await context.ConfirmAsync(Wording.Get("Machine.ContinueWithErrors")).ConfigureAwait(false);
        var placement = job.Motion.Program is { } program ? await context.Machine.Origins.AskAsync(program, mode.DryRun, cancellation).ConfigureAwait(false) : null;
        var certificate = job.Motion.Program is { } certified ? await CertificateStatusAsync(context, job, context.Machine.Connection.FitToLink(certified, mode.Strategy, job.Drawing).Program, cancellation).ConfigureAwait(false) : null;
        var checklist = ArmingChecklist.Create(job, context.Machine.Status, accepted, placement, context.Time.GetUtcNow(), certificate?.Check);
        foreach (var check in checklist.Checks) ArmingCheckText.Write(context, check);
        if (!checklist.Passed) throw new CommandException(CommandFailure.Refused, Wording.Get("CncArm.NotArmed"));
        return context.Machine.Runs.Arm(job, mode.Strategy, mode.DryRun, checklist);
    }

    /// <summary>The certificate status of the job; for the document's job the displayed status is updated too.</summary>
    private static Task<CertificateStatus> CertificateStatusAsync(CommandContext context, PreparedJob job, MotionProgram program, CancellationToken cancellation) =>
        ReferenceEquals(job, context.Derivation.Current.Job) ? context.Certificates.CheckAsync(job, program, cancellation) : Task.Run(() => CertificateStatus.OfRun(job, program), cancellation);

    /// <summary>The job that was derived already when it is of the same strategy; otherwise one that is prepared on another thread.</summary>
    private static async Task<PreparedJob> JobAsync(CommandContext context, ExecutionStrategy strategy, CancellationToken cancellation)
    {
        var plate = PlateStart.Take(context);
        if (context.Derivation is { IsCurrent: true, Current.Job: { } derived } && context.Derivation.Strategy == strategy && ReferenceEquals(derived.Source, context.Drawing)) return derived;
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        return await Task.Run(() => PlateJob.Prepare(drawing, settings, strategy.Style, plate, cancellation), cancellation).ConfigureAwait(false);
    }
}
