namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTOP: Stops the job: the machine decelerates and the tool is switched off. Never asks.</summary>
internal sealed class CncStopCommand : ICommand
{
    internal const string Name = "CNCSTOP";

    public CommandInfo Info { get; } = new(Name, CommandGroup.Machine) { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var connected = context.Machine.Connection.Description is not null;
        context.Say(context.Machine.Controls.Stop() ? Wording.Get("CncStop.Stopping") : connected ? Wording.Get("CncStop.StopSent") : Wording.Get("CncStop.NoJobRuns"));
        return Task.CompletedTask;
    }
}

/// <summary>CNCABORT: Halts every motion without deceleration, then switches the motors off. Never asks. Not an emergency stop.</summary>
internal sealed class CncAbortCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCABORT", CommandGroup.Machine) { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null && !context.Machine.IsRunning) throw new CommandException(CommandFailure.Usage, Wording.Get("Machine.NoControllerConnected"));
        context.Say(Wording.Get(context.Machine.Controls.Abort() ? "CncStop.Aborting" : "CncStop.StoppingOverSerialLine"));
        return Task.CompletedTask;
    }
}
