using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCMOTORS: Switches the motors of both axes on or off.</summary>
internal sealed class CncMotorsCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCMOTORS", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        var mode = await context.ChoiceAsync(Wording.Get("Common.EnterMode"), Keyword.List("ON", "OFF"), null).ConfigureAwait(false);
        if (await context.Machine.Hand.SetMotorsAsync(mode == "ON", cancellation).ConfigureAwait(false) is { } refused) throw new CommandException(CommandFailure.Refused, refused.Message);
        context.WriteMessage(Wording.Get("CncMotors.Motors", mode.ToLowerInvariant()));
    }
}
