using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The vector that MOVE and COPY ask for: from a base point to a second one, or typed as a displacement. Drawing units.</summary>
internal static class Displacement
{
    public static async Task<Vector2D> AskAsync(CommandContext context)
    {
        var first = await context.AskAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint")) { Options = Keyword.List("Displacement"), Default = "Displacement" }).ConfigureAwait(false);
        return first is Answer<Point2D>.Value { Of: var basePoint } ? await WayFromAsync(context, basePoint).ConfigureAwait(false) : await context.ValueAsync(new PointPrompt(Wording.Get("Displacement.SpecifyDisplacement"))).ConfigureAwait(false) - Point2D.Origin;
    }

    private static async Task<Vector2D> WayFromAsync(CommandContext context, Point2D basePoint)
    {
        var second = await context.AskAsync(new PointPrompt(Wording.Get("Common.SpecifySecondPointOr")) { EnterEnds = true, From = basePoint }).ConfigureAwait(false);
        return second is Answer<Point2D>.Value { Of: var point } ? point - basePoint : basePoint - Point2D.Origin;
    }
}
