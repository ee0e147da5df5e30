namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCABORT: Halts every motion without deceleration, then switches the motors off. Never asks. Not an emergency stop.</summary>
internal sealed class CncAbortCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCABORT", CommandGroup.Machine) { IsTransparent = true, IsAllowedDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null && !context.Machine.IsRunning) throw new CommandException(CommandFailure.Usage, Wording.Get("Machine.NoControllerConnected"));
        context.WriteMessage(Wording.Get(context.Machine.Controls.Abort() ? "CncStop.Aborting" : "CncStop.StoppingOverSerialLine"));
        return Task.CompletedTask;
    }
}
