using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCARM: Runs the start checks, and enables START for 60 s or until anything changes.</summary>
internal sealed class CncArmCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCARM", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (await ModeAsync(context).ConfigureAwait(false) is not { } mode)
        {
            context.WriteMessage(context.Machine.Arming.Disarm() ? Wording.Get("CncArm.Disarmed") : Wording.Get("CncArm.NothingArmed"));
            return;
        }

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
        var armed = context.Machine.Runs.Arm(job, mode.Strategy, mode.DryRun, checklist);
        context.WriteMessage(Wording.Get(mode.DryRun ? "CncArm.ArmedToolOff" : "CncArm.Armed", TimeZoneInfo.ConvertTime(armed.Until, context.Time.LocalTimeZone), mode.Strategy.Keyword));
    }

    /// <summary>The certificate status of the job; for the document's job the displayed status is updated too.</summary>
    private static Task<CertificateStatus> CertificateStatusAsync(CommandContext context, PreparedJob job, MotionProgram program, CancellationToken cancellation) =>
        ReferenceEquals(job, context.Derivation.Current.Job) ? context.Certificates.CheckAsync(job, program, cancellation) : Task.Run(() => CertificateStatus.OfRun(job, program), cancellation);

    /// <returns>Null: the operator chose to disarm.</returns>
    private static async Task<(ExecutionStrategy Strategy, bool DryRun, bool RunsTrajectories)?> ModeAsync(CommandContext context)
    {
        var (driver, dryRun, runsTrajectories) = (context.Driver, false, false);
        var remembered = driver.Strategies.FirstOrDefault(strategy => strategy.Keyword == context.LastValue("CNCARM")) ?? driver.DefaultStrategy;
        var answers = Keyword.List([.. driver.Strategies.Select(strategy => strategy.Keyword), "Dryrun", "Trajectories", "oFf"]);
        while (true)
        {
            var answer = await context.ChoiceAsync(Wording.Get(dryRun ? "CncArm.EnterModeToolOff" : "CncArm.EnterMode"), answers, remembered.Keyword).ConfigureAwait(false);
            if (answer == "oFf") return null;
            if (answer is "Dryrun" or "Trajectories")
            {
                (dryRun, runsTrajectories) = (dryRun || answer == "Dryrun", runsTrajectories != (answer == "Trajectories"));
                continue;
            }

            context.Remember("CNCARM", answer);
            return (driver.Strategies.First(strategy => strategy.Keyword == answer), dryRun, runsTrajectories);
        }
    }

    /// <summary>The job that was derived already when it is of the same strategy; otherwise one that is prepared on another thread.</summary>
    private static async Task<PreparedJob> JobAsync(CommandContext context, ExecutionStrategy strategy, CancellationToken cancellation)
    {
        var plate = PlateStart.Take(context);
        if (context.Derivation is { IsCurrent: true, Current.Job: { } derived } && context.Derivation.Strategy == strategy && ReferenceEquals(derived.Source, context.Drawing)) return derived;
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        return await Task.Run(() => PlateJob.Prepare(drawing, settings, strategy.Style, plate, cancellation), cancellation).ConfigureAwait(false);
    }
}
