namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCHOLD: Feed hold of the job: it decelerates on its path, then the tool is switched off or raised. CNCJOG may move the machine meanwhile. Never
/// asks.</summary>
internal sealed class CncHoldCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCHOLD", CommandGroup.Machine) { IsTransparent = true, IsAllowedDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (!context.Machine.Controls.HoldJob()) throw new CommandException(CommandFailure.Usage, Wording.Get("CncHold.NoJobRuns"));
        context.WriteMessage(Wording.Get("CncHold.Holding"));
        return Task.CompletedTask;
    }
}
