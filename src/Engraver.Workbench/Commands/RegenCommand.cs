namespace Engraver.Workbench.Commands;

/// <summary>REGEN: Draws the view anew and points at nothing any more.</summary>
internal sealed class RegenCommand : ICommand
{
    public CommandInfo Info { get; } = new("REGEN", CommandGroup.View, "Draws the view anew and points at nothing any more.") { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.View.Regenerate();
        return Task.CompletedTask;
    }
}
