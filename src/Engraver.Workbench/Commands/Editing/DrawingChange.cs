using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>Commits the result of an editing command: one undo step with an empty selection.</summary>
internal static class DrawingChange
{
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static void Transform(CommandContext context, IReadOnlyList<int> selected, Transform2D map, bool copy) => Commit(context, copy ? Copied(context, selected, [map]) : Mapped(context, selected, map), selected);

    /// <summary>True if mirrored texts stay readable (MIRRTEXT).</summary>
    public static bool KeepsTextDirection(CommandContext context) => context.Settings.Current.Variable("MIRRTEXT") == 0.0;

    /// <summary>Those of some objects that are curves of the drawing; the others are its texts.</summary>
    public static IReadOnlyList<int> CurvesOf(Drawing drawing, IReadOnlyList<int> objects) => objects.Any(index => index >= drawing.Entities.Count) ? [.. objects.Where(index => index < drawing.Entities.Count)] : objects;

    /// <summary>Transforms the whole drawing including locked layers, because relative positions do not change.</summary>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static void TransformAll(CommandContext context, Transform2D map)
    {
        IReadOnlyList<int> all = [.. Enumerable.Range(0, context.Drawing.Entities.Count + context.Drawing.Texts.Count)];
        Commit(context, Mapped(context, all, map, takesLocked: true), all);
    }

    /// <summary>The drawing with some objects transformed, and the texts that move with them.</summary>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    /// <param name="takesLocked">Texts and points on locked layers move too.</param>
    public static Drawing Mapped(CommandContext context, IReadOnlyList<int> selected, Transform2D map, bool takesLocked = false)
    {
        var drawing = context.Drawing;
        if (!DrawingEdit.TryTransform(drawing, CurvesOf(drawing, selected), map, out var edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        return AnnotationsOf(context, selected, takesLocked: takesLocked).Moved(edited, map);
    }

    /// <summary>The drawing with a transformed copy of some objects for each map, and of the texts and points that move with them.</summary>
    /// <param name="reports">False if the operator was already informed about texts and points that do not move.</param>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static Drawing Copied(CommandContext context, IReadOnlyList<int> selected, IReadOnlyList<Transform2D> maps, bool reports = true)
    {
        var edited = context.Drawing;
        foreach (var map in maps)
        {
            if (!DrawingEdit.TryCopy(edited, CurvesOf(context.Drawing, selected), map, out edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        }

        return AnnotationsOf(context, selected, reports, takesLocked: true).Copied(edited, maps);
    }

    /// <summary>Erases objects. Hidden objects stay hidden.</summary>
    /// <param name="asDoubles">True if the erased objects are duplicates: an erased entry entity is replaced by its duplicate.</param>
    public static void Erase(CommandContext context, IReadOnlyList<int> erased, bool asDoubles = false)
    {
        var gone = erased.Distinct().Order().ToList();
        var hidden = context.Document.Current.HiddenObjects.Except(gone).Select(index => index - CountBelow(gone, index));
        var erasedFrom = DrawingEdit.Erase(context.Drawing, CurvesOf(context.Drawing, gone));
        var left = asDoubles ? erasedFrom : AnnotationsOf(context, gone).Without(erasedFrom);
        Commit(context, left, [], [.. hidden], asDoubles ? Enumerable.Range(0, left.Entities.Count) : []);
    }

    /// <param name="previous">The edited objects, indices in the rebuilt drawing.</param>
    /// <param name="change">Settings that change in the same step; null for none.</param>
    public static void Commit(CommandContext context, DrawingRebuild rebuilt, IReadOnlyList<int> previous, Func<DrawingSettings, DrawingSettings>? change = null) =>
        Commit(context, rebuilt.Finish(), previous, rebuilt.NewIndices(context.Document.Current.HiddenObjects), previous, change);

    /// <summary>For an edit that keeps the indices of all objects.</summary>
    /// <param name="previous">The edited objects, indices before the edit.</param>
    public static void Commit(CommandContext context, Drawing edited, IReadOnlyList<int> previous) =>
        Commit(context, edited, DocumentState.Following(previous, context.Drawing, edited), context.Document.Current.HiddenObjects, []);

    /// <summary>The selected texts, and the texts and points that move with these objects; reports how many points do not.</summary>
    /// <param name="reports">False if this was already reported.</param>
    /// <param name="takesLocked">Also those on locked layers.</param>
    public static EditedAnnotations AnnotationsOf(CommandContext context, IReadOnlyList<int> selected, bool reports = true, bool takesLocked = false)
    {
        var along = EditedAnnotations.For(context.Drawing, selected, takesLocked, KeepsTextDirection(context));
        if (reports && along.UnmovedPoints > 0) context.WriteMessage(Wording.Get("DrawingChange.PointsUnchanged", CountText.Format(along.UnmovedPoints, "PointObject")));
        return along;
    }

    public static Drawing WithHidden(Drawing drawing, IEnumerable<int> indices, bool hidden) =>
        drawing with { Entities = drawing.Entities.With(indices.Select(index => (index, drawing.Entities[index] with { Hidden = hidden })), []) };

    private static int CountBelow(List<int> sorted, int index) => ~sorted.BinarySearch(index) is >= 0 and var below ? below : throw new ArgumentOutOfRangeException(nameof(index));

    /// <param name="substitutes">Indices of objects that may replace the removed ones.</param>
    private static void Commit(CommandContext context, Drawing edited, IReadOnlyList<int> previous, IReadOnlyList<int> hidden, IEnumerable<int> substitutes, Func<DrawingSettings, DrawingSettings>? change = null)
    {
        var state = context.Document.Current;
        var settings = state.Settings with { Enter = EnteringAfter(context, edited, substitutes) };
        if (change is not null) settings = change(settings);
        context.Commit(state with { Drawing = edited, Settings = settings, Selection = [], Previous = previous, HiddenObjects = hidden });
    }

    /// <summary>The start of cutting after an edit: the object that replaced the entry entity; this is reported.</summary>
    private static ContourEntry? EnteringAfter(CommandContext context, Drawing edited, IEnumerable<int> substitutes)
    {
        var place = context.Document.Current.Settings.Enter;
        if (place is not ContourEntry.ByHandle { Handle: var handle } || edited.IndexOfHandle(handle) is not null) return place;
        if (EntryHandleSubstitute.HandleOf(context.Drawing, handle, edited, substitutes) is { } other)
        {
            context.WriteMessage(Wording.Get("DrawingChange.EnteringEntityReplaced", handle, other));
            return new ContourEntry.ByHandle(other);
        }

        context.WriteMessage(Wording.Get("DrawingChange.EnteringEntityRemoved", handle));
        return null;
    }
}
