namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTOP: Stops the job: the machine brakes, the tool goes off. Never asks.</summary>
internal sealed class CncStopCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSTOP", CommandGroup.Machine, "Stops the job: the machine brakes, the tool goes off. Never asks.") { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var connected = context.Machine.Description is not null;
        context.Say(context.Machine.Stop() ? "Stopping." : connected ? "No job runs; the axes were told to stop all the same." : "No job runs.");
        return Task.CompletedTask;
    }
}

/// <summary>CNCABORT: Halts every motion at once without braking, then switches the motors off. Never asks. It is no emergency stop.</summary>
internal sealed class CncAbortCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCABORT", CommandGroup.Machine, "Halts every motion at once without braking, then switches the motors off. Never asks. It is no emergency stop.") { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Description is null && !context.Machine.IsRunning) throw new CommandException(CommandFailure.Usage, "No controller is connected.");
        context.Machine.Abort();
        context.Say("Aborting; the motors go off.");
        return Task.CompletedTask;
    }
}
