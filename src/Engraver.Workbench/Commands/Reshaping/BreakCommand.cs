using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>BREAK: Removes a piece of an object between two points, or splits it at one.</summary>
internal sealed class BreakCommand : ICommand
{
    public CommandInfo Info { get; } = new("BREAK", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var (entity, at) = await ObjectSelection.PickOneAsync(context, Wording.Get("Break.SelectObject")).ConfigureAwait(false);
        ObjectSelection.Unlocked(context, [entity]);
        var path = ReshapedDrawing.PathOf(drawing, entity) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Reshape.ZeroLength"));
        var (first, second) = await PlacesAsync(context, path, at).ConfigureAwait(false);
        var cut = CutOf(path, first, second);
        if (cut.Remaining.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Break.NothingLeft"));
        if (path.Closed && cut.Removed.Count == 0 && path.Parts.Count == 1) throw new CommandException(CommandFailure.Usage, Wording.Get("Break.ClosedCurveAtOnePoint"));
        var reshaped = new ReshapedDrawing(drawing);
        reshaped.Set(entity, cut.Remaining);
        var rebuilt = reshaped.Build();
        DrawingChange.Commit(context, rebuilt, reshaped.Places(rebuilt, [entity]));
    }

    /// <summary>The pick point is the first break point, unless another one is entered; <c>@</c> repeats it.</summary>
    private static async Task<(Point2D First, Point2D Second)> PlacesAsync(CommandContext context, EntityPath path, Point2D picked)
    {
        var second = await context.AskAsync(SecondPrompt(path, picked) with { Options = Keyword.List("First") }).ConfigureAwait(false);
        if (second is Answer<Point2D>.Value { Result: var place }) return (picked, place);
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Break.SpecifyFirst"))).ConfigureAwait(false);
        return (first, await context.ValueAsync(SecondPrompt(path, first)).ConfigureAwait(false));
    }

    private static PointPrompt SecondPrompt(EntityPath path, Point2D first) => new(Wording.Get("Break.SpecifySecond"))
    {
        Ghost = place => [.. CutOf(path, first, place).Removed.Select(piece => piece.Of(path.Parts[piece.Part]))],
    };

    /// <summary>A circle is broken counter-clockwise regardless of its direction.</summary>
    private static PathCut CutOf(EntityPath path, Point2D first, Point2D second)
    {
        var (from, to) = (path.Nearest(first), first == second ? path.Nearest(first) : path.Nearest(second));
        var isClockwise = path.Parts is [{ Kind: SegmentKind.Circle, Arc.Sweep.Degrees: < 0.0 }];
        return isClockwise ? PathCut.Break(path, to, from) : PathCut.Break(path, from, to);
    }
}
