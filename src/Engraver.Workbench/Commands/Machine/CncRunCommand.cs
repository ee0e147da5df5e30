using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCRUN: Runs the armed job (CNCARM) on the connected controller, in a script too; on a simulated one it also runs unarmed and asks first, the
/// drawing or its trajectories.</summary>
internal sealed class CncRunCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCRUN", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (context.RequiresManualStart) throw new CommandException(CommandFailure.Usage, Wording.Get("CncRun.ScriptCannotStart"));
        if (context.Machine.Arming.Armed is { } armed)
        {
            await RunArmedAsync(context, armed, cancellation).ConfigureAwait(false);
            return;
        }

        if (context.RunNeedsArming) throw new CommandException(CommandFailure.Usage, Wording.Get("CncRun.NotArmed", machine));
        var (driver, dryRun, runsTrajectories) = (context.Driver, false, false);
        var answers = Keyword.List(["Yes", "No", "Dryrun", "Trajectories", .. driver.Strategies.Select(one => one.Keyword)]);
        var strategy = context.Machine.Runs.Part?.Strategy ?? driver.DefaultStrategy;
        while (true)
        {
            var job = await JobStart.PrepareAsync(context, strategy, runsTrajectories).ConfigureAwait(false);
            JobStart.WritePart(context, job, strategy);
            var answer = await context.ChoiceAsync(Wording.Get(dryRun ? "CncRun.StartDryRun" : "CncRun.StartCutting", machine, strategy.Keyword), answers, "No").ConfigureAwait(false);
            if (answer == "No") return;
            if (answer == "Dryrun") dryRun = true;
            else if (answer == "Trajectories") runsTrajectories = !runsTrajectories;
            else if (driver.Strategies.FirstOrDefault(one => one.Keyword == answer) is { } chosen) strategy = chosen;
            else
            {
                if (!dryRun && !runsTrajectories && await PlateStart.DecideAsync(context).ConfigureAwait(false)) job = await JobStart.PrepareAsync(context, strategy).ConfigureAwait(false);
                await RunAsync(context, job, strategy, dryRun, cancellation).ConfigureAwait(false);
                return;
            }
        }
    }

    /// <summary>Runs what is armed.</summary>
    /// <exception cref="CommandException">The job did not complete.</exception>
    /// <exception cref="ControllerException">The link could not be established.</exception>
    public static Task RunArmedAsync(CommandContext context, ArmedJob armed, CancellationToken cancellation) => RunAsync(context, armed.Job, armed.Strategy, armed.DryRun, cancellation);

    private static async Task RunAsync(CommandContext context, PreparedJob job, ExecutionStrategy strategy, bool dryRun, CancellationToken cancellation)
    {
        var fit = context.Machine.Connection.FitToLink(job.Motion.Program!, strategy, job.Drawing);
        FindingMessages.Write(context, job.Drawing.FileName, fit.Diagnostics, Severity.Warning);
        var checks = context.Machine.Arming.Armed?.Checklist;
        await JobStart.RunAsync(context, job, checks, options => context.Machine.Runs.RunAsync(job, fit.Program, address => options(JobStart.Options(context, job, address, strategy, dryRun)), cancellation), simulated: false).ConfigureAwait(false);
    }
}
