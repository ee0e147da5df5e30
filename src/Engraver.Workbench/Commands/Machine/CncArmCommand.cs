using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCARM: Checks everything that must be so before a start, and lets START work for 60 s or until anything changes.</summary>
internal sealed class CncArmCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List([.. Enum.GetNames<JobMode>(), "Dryrun", "Trajectories", "oFf"]);

    public CommandInfo Info { get; } = new("CNCARM", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (await ModeAsync(context).ConfigureAwait(false) is not { } mode)
        {
            context.Say(context.Machine.Arming.Disarm() ? Wording.Get("CncArm.Disarmed") : Wording.Get("CncArm.NothingArmed"));
            return;
        }

        var job = mode.RunsTrajectories ? JobStart.Followed(context, mode.Mode) : await JobAsync(context, mode.Mode, cancellation).ConfigureAwait(false);
        JobStart.SayPart(context, job, mode.Mode);
        var hasErrors = job.Diagnostics.Any(found => found.Severity == Severity.Error);
        var accepted = hasErrors && await context.ConfirmAsync(Wording.Get("Machine.ContinueWithErrors")).ConfigureAwait(false);
        var placement = job.Motion.Program is { } program ? await context.Machine.Origins.AskAsync(program, mode.DryRun, cancellation).ConfigureAwait(false) : null;
        var certificate = job.Motion.Program is { } certified ? await StandingAsync(context, job, context.Machine.Connection.FitToLink(certified, mode.Mode, job.Drawing).Program, cancellation).ConfigureAwait(false) : null;
        var checklist = ArmingChecklist.Create(job, context.Machine.Status, accepted, placement, context.Time.GetUtcNow(), certificate?.Check);
        foreach (var check in checklist.Checks) CheckText.Say(context, check);
        if (!checklist.Passed) throw new CommandException(CommandFailure.Refused, Wording.Get("CncArm.NotArmed"));
        var armed = context.Machine.Runs.Arm(job, mode.Mode, mode.DryRun, checklist);
        context.Say(Wording.Get(mode.DryRun ? "CncArm.ArmedToolOff" : "CncArm.Armed", TimeZoneInfo.ConvertTime(armed.Until, context.Time.LocalTimeZone), mode.Mode));
    }

    /// <summary>How the job stands to its certificate now; where it is the job of the document, the list that is always shown hears of it too.</summary>
    private static Task<CertificateStanding> StandingAsync(CommandContext context, PreparedJob job, MotionProgram program, CancellationToken cancellation) =>
        ReferenceEquals(job, context.Derivation.Current.Job) ? context.Certificates.LookAsync(job, program, cancellation) : Task.Run(() => CertificateStanding.OfRun(job, program), cancellation);

    /// <returns>Null: the operator chose to disarm.</returns>
    private static async Task<(JobMode Mode, bool DryRun, bool RunsTrajectories)?> ModeAsync(CommandContext context)
    {
        var (dryRun, runsTrajectories) = (false, false);
        while (true)
        {
            var answer = await context.ChoiceAsync(Wording.Get(dryRun ? "CncArm.EnterModeToolOff" : "CncArm.EnterMode"), s_answers, context.Remembered("CNCARM", nameof(JobMode.Stream))).ConfigureAwait(false);
            if (answer == "oFf") return null;
            if (answer is "Dryrun" or "Trajectories")
            {
                (dryRun, runsTrajectories) = (dryRun || answer == "Dryrun", runsTrajectories != (answer == "Trajectories"));
                continue;
            }

            context.Remember("CNCARM", answer);
            return (Enum.Parse<JobMode>(answer), dryRun, runsTrajectories);
        }
    }

    /// <summary>The job that was derived already when it is of the same mode; otherwise one that is prepared on another thread.</summary>
    private static async Task<PreparedJob> JobAsync(CommandContext context, JobMode mode, CancellationToken cancellation)
    {
        if (context.Derivation is { IsCurrent: true, Current.Job: { } derived } && context.Derivation.Mode == mode && ReferenceEquals(derived.Drawing, context.Drawing)) return derived;
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        return await Task.Run(() => JobPreparation.PrepareUnlessCancelled(drawing, settings, JobPlan.StyleOf(mode), cancellation), cancellation).ConfigureAwait(false);
    }
}

/// <summary>The list before a start, line by line.</summary>
internal static class CheckText
{
    public static void Say(CommandContext context, ArmingCheck check) =>
        context.Say(check.Line, check switch { { IsWarning: true } => MessageKind.Warning, { Passed: true } => MessageKind.Result, _ => MessageKind.Error });
}
