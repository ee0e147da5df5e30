namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCDISCONNECT: Closes the connection to the controller.</summary>
internal sealed class CncDisconnectCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCDISCONNECT", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Machine.NoControllerConnected"));
        await context.Machine.Connection.DisconnectAsync().ConfigureAwait(false);
        context.WriteMessage(Wording.Get("CncConnect.Disconnected"));
    }
}
