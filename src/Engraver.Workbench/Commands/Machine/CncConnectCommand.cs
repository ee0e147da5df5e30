using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCCONNECT: Connects to a controller: tcp://HOST:PORT, or sim: for the simulated one.</summary>
internal sealed class CncConnectCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCCONNECT", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("CncConnect.EnterAddress")) { Default = context.Settings.Current.LastAddress ?? "sim:" }).ConfigureAwait(false);
        if (!context.Families.TryParseAddress(typed, out var address)) throw new CommandException(CommandFailure.Usage, context.Families.NotAnAddress(typed));
        try
        {
            var identity = await context.Machine.Connection.ConnectAsync(address is SimulatedAddress { HasExplicitSpeed: false } ? new SimulatedAddress(context.SimulatorSpeed) : address, cancellation).ConfigureAwait(false);
            context.Settings.Change(settings => settings with { LastAddress = typed });
            context.WriteMessage(Wording.Get("CncConnect.Connected", identity.Model, context.Machine.Connection.Description));
        }
        catch (NotSupportedException unbuilt)
        {
            throw new CommandException(CommandFailure.Usage, unbuilt.Message);
        }
    }
}
