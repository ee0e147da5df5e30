using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>Prompts for the vector of MOVE and COPY: from a base point to a second one, or typed as a displacement. Drawing units.</summary>
internal static class DisplacementPrompts
{
    public static async Task<Vector2D> AskAsync(CommandContext context, SelectionGhost ghost) =>
        await BaseAsync(context).ConfigureAwait(false) is { } basePoint ? await WayFromAsync(context, ghost, basePoint).ConfigureAwait(false) : await TypedAsync(context, ghost).ConfigureAwait(false);

    /// <summary>The base point; null if a displacement is entered instead.</summary>
    public static async Task<Point2D?> BaseAsync(CommandContext context)
    {
        var first = await context.AskAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint")) { Options = Keyword.List("Displacement"), Default = "Displacement" }).ConfigureAwait(false);
        return first is Answer<Point2D>.Value { Result: var basePoint } ? basePoint : null;
    }

    public static async Task<Vector2D> TypedAsync(CommandContext context, SelectionGhost ghost) =>
        await context.ValueAsync(new PointPrompt(Wording.Get("Displacement.SpecifyDisplacement")) { Ghost = GhostFrom(ghost, Point2D.Origin), From = Point2D.Origin }).ConfigureAwait(false) - Point2D.Origin;

    /// <summary>Preview of the objects moved from the base point to the cursor.</summary>
    public static GhostFunction GhostFrom(SelectionGhost ghost, Point2D basePoint) => place => ghost.Mapped(Transform2D.Move(place - basePoint));

    private static async Task<Vector2D> WayFromAsync(CommandContext context, SelectionGhost ghost, Point2D basePoint)
    {
        var second = await context.AskAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPointOrDisplacement")) { EnterEnds = true, From = basePoint, Ghost = GhostFrom(ghost, basePoint) }).ConfigureAwait(false);
        return second is Answer<Point2D>.Value { Result: var point } ? point - basePoint : basePoint - Point2D.Origin;
    }
}
