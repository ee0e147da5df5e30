using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCCONTINUE: Continues a job after a change of the tool or a stop between repeats: asks, passes the checks of CNCARM and runs the rest.</summary>
internal sealed class CncContinueCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCCONTINUE", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (context.RequiresManualStart) throw new CommandException(CommandFailure.Usage, Wording.Get("CncRun.ScriptCannotStart"));
        if (context.Machine.Runs.Part is not { Break: { } at } part) throw new CommandException(CommandFailure.Usage, Wording.Get("CncContinue.NothingWaits"));
        if (!await context.ConfirmAsync(Question(at)).ConfigureAwait(false)) return;
        if (at.NeedsHeight(context.Machine.Profile) && !await context.ConfirmAsync(Wording.Get("CncContinue.ConfirmHeight", at.NextText)).ConfigureAwait(false)) return;
        var armed = await JobArming.ArmAsync(context, new ArmingMode(part.Strategy ?? context.Driver.DefaultStrategy, DryRun: false, RunsTrajectories: false), cancellation).ConfigureAwait(false);
        await CncRunCommand.RunArmedAsync(context, armed, cancellation).ConfigureAwait(false);
    }

    private static string Question(SectionBreak at) => Wording.Get(at.IsToolChange ? "CncContinue.ConfirmTool" : "CncContinue.ConfirmRepeat", at.NextText);
}
