using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>MATCHPROP: Gives objects the layer and the colour of another.</summary>
internal sealed class MatchPropertiesCommand : ICommand
{
    private const string Last = "MATCHPROP";

    public CommandInfo Info { get; } = new("MATCHPROP", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var source = await SourceAsync(context).ConfigureAwait(false);
        var steps = new EditUndo(context);
        while (true)
        {
            context.HighlightPicked([source]);
            var matched = context.LastValue(Last, "All");
            context.WriteMessage(Wording.Get("MatchProp.Active", new Keyword(matched).Shown));
            switch (await context.AskAsync(new PointPrompt(Wording.Get("MatchProp.SelectDestination")) { Options = Keyword.List("Settings", "Undo"), EnterEnds = true, Purpose = PointPurpose.Object }).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var at }:
                    var found = await FoundAsync(context, at).ConfigureAwait(false);
                    if (found.Count == 0) context.WriteMessage(Wording.Get("Offset.NoObjectAtPoint"));
                    steps.Run(() => Match(context, source, ObjectSelection.WithoutLocked(context, found), matched));
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }:
                    steps.Undo();
                    break;
                case Answer<Point2D>.SelectedOption:
                    context.Remember(Last, await context.ChoiceAsync(Wording.Get("MatchProp.Which"), Keyword.List("All", "Layer", "Color"), matched).ConfigureAwait(false));
                    break;
                default:
                    return;
            }
        }
    }

    private static async Task<int> SourceAsync(CommandContext context)
    {
        if (context.Document.Current.Selection is [var only] && only < context.Drawing.Entities.Count) return only;
        return (await ObjectSelection.PickOneAsync(context, Wording.Get("MatchProp.SelectSource")).ConfigureAwait(false)).Entity;
    }

    private static async Task<IReadOnlyList<int>> FoundAsync(CommandContext context, Point2D at)
    {
        if (ObjectSelection.EntityAt(context, at) is { } entity) return [entity];
        var corner = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = at }).ConfigureAwait(false);
        var box = Bounds2D.FromCorners(at, corner);
        return [.. corner.X >= at.X ? DrawingPick.Inside(context.Drawing, box) : DrawingPick.Touching(context.Drawing, box)];
    }

    private static void Match(CommandContext context, int source, IReadOnlyList<int> found, string matched)
    {
        var (drawing, like) = (context.Drawing, context.Drawing.Entities[source]);
        var changed = found.Select(entity => (entity, Like(drawing.Entities[entity], like, matched))).Where(change => change.Item2 is var next && (next.Layer, next.Colour) != (drawing.Entities[change.entity].Layer, drawing.Entities[change.entity].Colour)).ToList();
        if (changed.Count > 0) DrawingChange.Commit(context, drawing with { Entities = drawing.Entities.With(changed, []) }, found);
    }

    private static DrawingEntity Like(DrawingEntity entity, in DrawingEntity source, string matched)
    {
        if (matched != "Color") entity.Layer = source.Layer;
        if (matched != "Layer") entity.Colour = source.Colour;
        return entity;
    }
}
