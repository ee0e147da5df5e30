using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCCONNECT: Connects to a controller: tcp://HOST:PORT, or sim: for the simulated one.</summary>
internal sealed class CncConnectCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCCONNECT", CommandGroup.Machine, "Connects to a controller: tcp://HOST:PORT, or sim: for the simulated one.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var typed = await context.ValueAsync(new TextPrompt("Enter address of the controller") { Default = context.Settings.Current.LastAddress ?? "sim:" }).ConfigureAwait(false);
        if (!ControllerAddress.TryParse(typed, out var address)) throw new CommandException(CommandFailure.Usage, $"'{typed}' is no controller address; write tcp://HOST:PORT or sim:.");
        try
        {
            var identity = await context.Machine.ConnectAsync(address is SimulatedAddress { SaysSpeed: false } ? new SimulatedAddress(context.SimulatorSpeed) : address, cancellation).ConfigureAwait(false);
            context.Settings.Change(settings => settings with { LastAddress = typed });
            context.Say($"Connected to {identity.Model} at {context.Machine.Description}.");
        }
        catch (NotSupportedException unbuilt)
        {
            throw new CommandException(CommandFailure.Usage, unbuilt.Message);
        }
    }
}

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
