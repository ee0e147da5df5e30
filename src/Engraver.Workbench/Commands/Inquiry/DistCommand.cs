using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>DIST: Measures distance and angle between two points.</summary>
internal sealed class DistCommand : ICommand
{
    public CommandInfo Info { get; } = new("DIST", CommandGroup.Ask) { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Dist.SpecifyFirstPoint"))).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPoint")) { From = first }).ConfigureAwait(false);
        var (way, figures) = (second - first, context.Figures);
        context.Say(
            Wording.Get("Dist.Distance", figures.Length(way.Length), figures.Degrees(way.Direction.Positive()), figures.Length(way.X), figures.Length(way.Y)),
            MessageKind.Result);
    }
}

/// <summary>ID: Shows the coordinates of a point and makes it the last point (@).</summary>
internal sealed class IdCommand : ICommand
{
    public CommandInfo Info { get; } = new("ID", CommandGroup.Ask) { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var point = await context.ValueAsync(new PointPrompt(Wording.Get("Dist.SpecifyPoint"))).ConfigureAwait(false);
        context.Say(Wording.Get("Dist.Coordinates", context.Figures.Length(point.X), context.Figures.Length(point.Y)), MessageKind.Result);
    }
}
