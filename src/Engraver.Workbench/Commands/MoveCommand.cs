using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>MOVE: Moves objects.</summary>
internal sealed class MoveCommand : ICommand
{
    public CommandInfo Info { get; } = new("MOVE", CommandGroup.Drawing, "Moves objects.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var first = await context.AskAsync(new PointPrompt("Specify base point") { Options = Keyword.List("Displacement"), Default = "Displacement" }).ConfigureAwait(false);
        var by = first is Answer<Point2D>.Value { Of: var basePoint } ? await WayFromAsync(context, basePoint).ConfigureAwait(false) : await DisplacementAsync(context).ConfigureAwait(false);
        DrawingChange.Transform(context, selected, Transform2D.Move(by), copy: false);
    }

    private static async Task<Vector2D> WayFromAsync(CommandContext context, Point2D basePoint)
    {
        var second = await context.AskAsync(new PointPrompt("Specify second point, or Enter to use the first point as displacement") { EnterEnds = true }).ConfigureAwait(false);
        return second is Answer<Point2D>.Value { Of: var point } ? point - basePoint : basePoint - Point2D.Origin;
    }

    private static async Task<Vector2D> DisplacementAsync(CommandContext context) =>
        await context.ValueAsync(new PointPrompt("Specify displacement")).ConfigureAwait(false) - Point2D.Origin;
}
