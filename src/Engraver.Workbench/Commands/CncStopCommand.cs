namespace Engraver.Workbench.Commands;

/// <summary>CNCSTOP: Stops the job: the machine brakes, the tool goes off. Never asks.</summary>
internal sealed class CncStopCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSTOP", CommandGroup.Machine, "Stops the job: the machine brakes, the tool goes off. Never asks.") { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Machine.Stop() ? "Stopping." : "No job runs.");
        return Task.CompletedTask;
    }
}
