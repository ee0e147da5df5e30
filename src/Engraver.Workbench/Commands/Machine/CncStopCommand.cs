namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTOP: Stops the job: the machine decelerates and the tool is switched off. Never asks.</summary>
internal sealed class CncStopCommand : ICommand
{
    internal const string Name = "CNCSTOP";

    public CommandInfo Info { get; } = new(Name, CommandGroup.Machine) { IsTransparent = true, IsAllowedDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var connected = context.Machine.Connection.Description is not null;
        context.WriteMessage(context.Machine.Controls.Stop() ? Wording.Get("CncStop.Stopping") : connected ? Wording.Get("CncStop.StopSent") : Wording.Get("CncStop.NoJobRuns"));
        return Task.CompletedTask;
    }
}
