namespace Engraver.Workbench.Commands;

/// <summary>CNCDISCONNECT: Lets the controller go.</summary>
internal sealed class CncDisconnectCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCDISCONNECT", CommandGroup.Machine, "Lets the controller go.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Description is null) throw new CommandException(CommandFailure.Usage, "No controller is connected.");
        await context.Machine.DisconnectAsync().ConfigureAwait(false);
        context.Say("Disconnected.");
    }
}
