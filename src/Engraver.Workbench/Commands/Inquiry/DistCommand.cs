using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>DIST: Measures distance and angle between two points.</summary>
internal sealed class DistCommand : ICommand
{
    public CommandInfo Info { get; } = new("DIST", CommandGroup.Ask, "Measures distance and angle between two points.") { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.ValueAsync(new PointPrompt("Specify first point")).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt("Specify second point") { From = first }).ConfigureAwait(false);
        var way = second - first;
        context.Say(
            $"Distance = {NumberPrompt.Show(way.Length)}, Angle in XY Plane = {NumberPrompt.Show(way.Direction.Positive().Degrees)}, Delta X = {NumberPrompt.Show(way.X)}, Delta Y = {NumberPrompt.Show(way.Y)}",
            MessageKind.Result);
    }
}

/// <summary>ID: Says the coordinates of a point and makes it the last point (@).</summary>
internal sealed class IdCommand : ICommand
{
    public CommandInfo Info { get; } = new("ID", CommandGroup.Ask, "Says the coordinates of a point and makes it the last point (@).") { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var point = await context.ValueAsync(new PointPrompt("Specify point")).ConfigureAwait(false);
        context.Say($"X = {NumberPrompt.Show(point.X)}     Y = {NumberPrompt.Show(point.Y)}", MessageKind.Result);
    }
}
