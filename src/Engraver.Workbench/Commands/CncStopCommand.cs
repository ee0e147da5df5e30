namespace Engraver.Workbench.Commands;

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
