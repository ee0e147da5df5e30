using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.View;

/// <summary>PAN: Moves the view by a vector.</summary>
internal sealed class PanCommand : ICommand
{
    public CommandInfo Info { get; } = new("PAN", CommandGroup.View) { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Pan.SpecifyBasePoint"))).ConfigureAwait(false);
        var second = await context.AskAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPointOrDisplacement")) { EnterEnds = true, From = first }).ConfigureAwait(false);
        var way = second is Answer<Point2D>.Value { Of: var point } ? point - first : first - Point2D.Origin;
        var view = context.View.Current;
        context.View.SetCentre(view.Centre - way, view.Height);
    }
}

/// <summary>REGEN: Redraws the view and removes the mark of a finding. Restarts planning that was cancelled by Esc.</summary>
internal sealed class RegenCommand : ICommand
{
    public CommandInfo Info { get; } = new("REGEN", CommandGroup.View) { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.View.Regenerate();
        if (!context.Derivation.IsGivenUp) return Task.CompletedTask;
        _ = context.Derivation.ForCurrentAsync(CancellationToken.None);
        context.Say(Wording.Get("Regen.Planning"));
        return Task.CompletedTask;
    }
}
