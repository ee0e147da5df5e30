namespace Engraver.Workbench.Commands.View;

/// <summary>REGEN: Redraws the view and removes the mark of a finding. Restarts planning that was cancelled by Esc.</summary>
internal sealed class RegenCommand : ICommand
{
    public CommandInfo Info { get; } = new("REGEN", CommandGroup.View) { IsTransparent = true, IsAllowedDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.View.Regenerate();
        if (!context.Derivation.IsCancelled) return Task.CompletedTask;
        _ = context.Derivation.ForCurrentAsync(CancellationToken.None);
        context.WriteMessage(Wording.Get("Regen.Planning"));
        return Task.CompletedTask;
    }
}
