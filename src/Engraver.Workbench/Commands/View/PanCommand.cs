using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.View;

/// <summary>PAN: Moves the view by a vector.</summary>
internal sealed class PanCommand : ICommand
{
    public CommandInfo Info { get; } = new("PAN", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Pan.SpecifyBasePoint"))).ConfigureAwait(false);
        var second = await context.AskAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPointOrDisplacement")) { EnterEnds = true, From = first }).ConfigureAwait(false);
        var way = second is Answer<Point2D>.Value { Result: var point } ? point - first : first - Point2D.Origin;
        var view = context.View.Current;
        context.View.SetCentre(view.Centre - way, view.Height);
    }
}
