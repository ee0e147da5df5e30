using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>DIST: Measures distance and angle between two points.</summary>
internal sealed class DistCommand : ICommand
{
    public CommandInfo Info { get; } = new("DIST", CommandGroup.Ask) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Dist.SpecifyFirstPoint"))).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPoint")) { From = first }).ConfigureAwait(false);
        var (way, figures) = (second - first, context.Precision);
        context.WriteMessage(
            Wording.Get("Dist.Distance", figures.FormatLength(way.Length), figures.FormatDegrees(way.Direction.Positive()), figures.FormatLength(way.X), figures.FormatLength(way.Y)),
            MessageKind.Result);
    }
}
