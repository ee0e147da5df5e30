using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>TRIM: Cuts objects at edges. EXTEND: Lengthens them to edges. Shift turns one into the other.</summary>
internal sealed class TrimCommand : ICommand
{
    private readonly bool _extends;

    private TrimCommand(string name, bool extends) => (Info, _extends) = (new CommandInfo(name, CommandGroup.Drawing), extends);

    public static IReadOnlyList<ICommand> All { get; } = [new TrimCommand("TRIM", extends: false), new TrimCommand("EXTEND", extends: true)];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var edges = await EdgesAsync(context).ConfigureAwait(false);
        var steps = new EditUndo(context);
        while (true)
        {
            switch (await context.AskAsync(Prompt(context, edges)).ConfigureAwait(false))
            {
                case Answer<ObjectPick>.Value { Result: var pick }:
                    var picked = await PickedAsync(context, pick.At).ConfigureAwait(false);
                    steps.Run(() => Commit(context, edges, picked, pick.IsShifted ^ _extends));
                    break;
                case Answer<ObjectPick>.SelectedOption { Option: "Undo" }:
                    if (steps.Undo()) edges.Undo();
                    break;
                case Answer<ObjectPick>.SelectedOption { Option: var option }:
                    await ApplyOptionAsync(context, steps, edges, option).ConfigureAwait(false);
                    break;
                default:
                    return;
            }
        }
    }

    /// <summary>The cutting or boundary edges: the previous selection, otherwise prompts for it; an empty selection means all.</summary>
    private async Task<ReshapeEdges> EdgesAsync(CommandContext context)
    {
        var before = ObjectSelection.CurvesOf(context, context.Document.Current.Selection);
        if (before.Count > 0) context.WriteMessage(Wording.Get("ObjectSelection.Found", before.Count));
        var selected = before.Count > 0 ? before : await ObjectSelection.PickAsync(context, Wording.Get(_extends ? "Extend.SelectEdges" : "Trim.SelectEdges")).ConfigureAwait(false);
        return new ReshapeEdges(selected.Count == 0 ? null : selected) { AreLengthened = context.LastValue(ReshapeEdges.Mode) == "Extend" };
    }

    private PickPrompt Prompt(CommandContext context, ReshapeEdges edges)
    {
        var drawing = context.Drawing;
        return new PickPrompt(Wording.Get(_extends ? "Extend.SelectObject" : "Trim.SelectObject"))
        {
            Options = _extends ? Keyword.List("Fence", "Crossing", "Edge", "Undo") : Keyword.List("Fence", "Crossing", "Edge", "eRase", "Undo"),
            EnterEnds = true,
            Ghost = place => ObjectSelection.EntityAt(context, place) is { } entity && edges.Reshape(drawing, entity, place, _extends) is { } shape ? shape.Preview : [],
        };
    }

    private async Task ApplyOptionAsync(CommandContext context, EditUndo steps, ReshapeEdges edges, string option)
    {
        switch (option)
        {
            case "Edge":
                var mode = await context.ChoiceAsync(Wording.Get("Trim.EdgeMode"), Keyword.List("Extend", "No"), edges.AreLengthened ? "Extend" : "No").ConfigureAwait(false);
                context.Remember(ReshapeEdges.Mode, mode);
                edges.AreLengthened = mode == "Extend";
                break;
            case "eRase":
                var erased = await ObjectSelection.PickAsync(context, Wording.Get("ObjectSelection.SelectObjects")).ConfigureAwait(false);
                if (ObjectSelection.WithoutLocked(context, erased) is { Count: > 0 } free) steps.Run(() => Erase(context, edges, free));
                break;
            default:
                var picked = option == "Fence" ? await FenceAsync(context).ConfigureAwait(false) : Crossed(context.Drawing, await BoxAsync(context, null).ConfigureAwait(false));
                steps.Run(() => Commit(context, edges, picked, _extends));
                break;
        }
    }

    /// <summary>The object at a point, or at an empty point the objects that a box from there crosses.</summary>
    private static async Task<IReadOnlyList<(int Entity, Point2D At)>> PickedAsync(CommandContext context, Point2D at) =>
        ObjectSelection.EntityAt(context, at) is { } entity ? [(entity, at)] : Crossed(context.Drawing, await BoxAsync(context, at).ConfigureAwait(false));

    private static async Task<Bounds2D> BoxAsync(CommandContext context, Point2D? corner)
    {
        var first = corner ?? await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyFirstCorner")) { Purpose = PointPurpose.Corner }).ConfigureAwait(false);
        return Bounds2D.FromCorners(first, await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = first }).ConfigureAwait(false));
    }

    private static async Task<IReadOnlyList<(int Entity, Point2D At)>> FenceAsync(CommandContext context)
    {
        var places = new List<Point2D> { await context.ValueAsync(new PointPrompt(Wording.Get("Trim.FirstFencePoint"))).ConfigureAwait(false) };
        while (await context.AskAsync(new PointPrompt(Wording.Get("Trim.NextFencePoint")) { EnterEnds = true, From = places[^1] }).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var next }) places.Add(next);
        return Met(context.Drawing, [.. places.Zip(places.Skip(1)).Select(pair => Segment.FromLine(pair.First, pair.Second))]);
    }

    private static IReadOnlyList<(int Entity, Point2D At)> Crossed(Drawing drawing, Bounds2D box)
    {
        Point2D[] corners = [new(box.MinX, box.MinY), new(box.MaxX, box.MinY), new(box.MaxX, box.MaxY), new(box.MinX, box.MaxY)];
        return Met(drawing, [.. corners.Zip([.. corners.Skip(1), corners[0]]).Select(pair => Segment.FromLine(pair.First, pair.Second))]);
    }

    /// <summary>Every visible object that these lines cross, and its first intersection.</summary>
    private static IReadOnlyList<(int Entity, Point2D At)> Met(Drawing drawing, IReadOnlyList<Segment> fence) =>
        [.. from entity in DrawingPick.Visible(drawing)
            let at = fence.SelectMany(line => DrawingPick.Segments(drawing, entity).SelectMany(part => SegmentCrossings.Find(line, part))).Select(place => (Point2D?)place).FirstOrDefault()
            where at is not null
            select (entity, at.Value)];

    private static void Commit(CommandContext context, ReshapeEdges edges, IReadOnlyList<(int Entity, Point2D At)> picked, bool extends)
    {
        if (picked.Count == 0) context.WriteMessage(Wording.Get("Offset.NoObjectAtPoint"));
        var (drawing, reshaped) = (context.Drawing, new ReshapedDrawing(context.Drawing));
        var free = ObjectSelection.WithoutLocked(context, [.. picked.Select(one => one.Entity)]).ToHashSet();
        foreach (var (entity, at) in picked.Where(one => free.Contains(one.Entity)))
        {
            if (edges.Reshape(drawing, entity, at, extends) is { } shape) reshaped.Set(entity, shape.Kept);
            else context.WriteMessage(ReshapeEdges.RefusalOf(drawing, entity, extends));
        }

        if (reshaped.Count == 0) return;
        var rebuilt = reshaped.Build();
        DrawingChange.Commit(context, rebuilt, reshaped.Places(rebuilt, picked.Select(one => one.Entity)));
        edges.Remap(all => reshaped.Places(rebuilt, all));
    }

    private static void Erase(CommandContext context, ReshapeEdges edges, IReadOnlyList<int> erased)
    {
        var gone = erased.Distinct().Order().ToList();
        DrawingChange.Erase(context, gone);
        edges.Remap(all => [.. all.Where(entity => gone.BinarySearch(entity) < 0).Select(entity => entity + gone.BinarySearch(entity) + 1)]);
    }
}
