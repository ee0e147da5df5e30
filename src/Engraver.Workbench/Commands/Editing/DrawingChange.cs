using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The last act of every command that edits: one document step, nothing selected afterwards.</summary>
internal static class DrawingChange
{
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static void Transform(CommandContext context, IReadOnlyList<int> selected, Transform2D map, bool copy) => Take(context, copy ? Copied(context, selected, [map]) : Mapped(context, selected, map), selected);

    /// <summary>Moves the whole drawing, with what lies on locked layers: nothing of it changes its place in the drawing.</summary>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static void TransformWhole(CommandContext context, Transform2D map)
    {
        IReadOnlyList<int> all = [.. Enumerable.Range(0, context.Drawing.Entities.Count)];
        Take(context, Mapped(context, all, map, takesLocked: true), all);
    }

    /// <summary>The drawing with some objects under a map, and the texts that go along.</summary>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    /// <param name="takesLocked">Texts and points of locked layers go along.</param>
    public static Drawing Mapped(CommandContext context, IReadOnlyList<int> selected, Transform2D map, bool takesLocked = false)
    {
        var drawing = context.Drawing;
        if (!DrawingEdit.TryTransform(drawing, selected, map, out var edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        return Along(context, selected, takesLocked: takesLocked).Moved(edited, map);
    }

    /// <summary>The drawing with a copy of some objects under each map, and of the texts and points that go along.</summary>
    /// <param name="tells">False when the operator was told before of what does not go along.</param>
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static Drawing Copied(CommandContext context, IReadOnlyList<int> selected, IReadOnlyList<Transform2D> maps, bool tells = true)
    {
        var edited = context.Drawing;
        foreach (var map in maps)
        {
            if (!DrawingEdit.TryCopy(edited, selected, map, out edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        }

        return Along(context, selected, tells, takesLocked: true).Copied(edited, maps);
    }

    /// <summary>Erases objects. Hidden objects stay hidden, though their indices change.</summary>
    /// <param name="asDoubles">True when other objects lie on the erased ones: when the entering entity is erased, one of the others becomes it.</param>
    public static void Erase(CommandContext context, IReadOnlyList<int> erased, bool asDoubles = false)
    {
        var gone = erased.Distinct().Order().ToList();
        var hidden = context.Document.Current.HiddenObjects.Except(gone).Select(index => index - BelowIn(gone, index));
        var erasedFrom = DrawingEdit.Erase(context.Drawing, gone);
        var left = asDoubles ? erasedFrom : Along(context, gone).Without(erasedFrom);
        Take(context, left, [], [.. hidden], asDoubles ? Enumerable.Range(0, left.Entities.Count) : []);
    }

    /// <param name="previous">What the command worked on, by its index in the rebuilt drawing.</param>
    /// <param name="change">Settings that change in the same step; null for none.</param>
    public static void Take(CommandContext context, DrawingRebuild rebuilt, IReadOnlyList<int> previous, Func<DrawingSettings, DrawingSettings>? change = null) =>
        Take(context, rebuilt.Finish(), previous, rebuilt.Places(context.Document.Current.HiddenObjects), previous, change);

    /// <summary>For an edit that leaves every object in its place.</summary>
    /// <param name="previous">What the command worked on, by its index in the edited drawing.</param>
    public static void Take(CommandContext context, Drawing edited, IReadOnlyList<int> previous) => Take(context, edited, previous, context.Document.Current.HiddenObjects, []);

    /// <summary>The texts and points that move with these curves; tells the operator how many do not.</summary>
    /// <param name="tells">False when it was told before.</param>
    /// <param name="takesLocked">Also those on locked layers.</param>
    public static EditedAnnotations Along(CommandContext context, IReadOnlyList<int> selected, bool tells = true, bool takesLocked = false)
    {
        var along = EditedAnnotations.Along(context.Drawing, selected, takesLocked);
        if (tells && along.TextsLeft > 0) context.Say(Wording.Get("DrawingChange.TextsUnchanged", CountText.Format(along.TextsLeft, "Text")));
        if (tells && along.PointsLeft > 0) context.Say(Wording.Get("DrawingChange.PointsUnchanged", CountText.Format(along.PointsLeft, "PointObject")));
        return along;
    }

    public static Drawing WithHidden(Drawing drawing, IEnumerable<int> indices, bool hidden) =>
        drawing with { Entities = drawing.Entities.With(indices.Select(index => (index, drawing.Entities[index] with { Hidden = hidden })), []) };

    private static int BelowIn(List<int> sorted, int index) => ~sorted.BinarySearch(index) is >= 0 and var below ? below : throw new ArgumentOutOfRangeException(nameof(index));

    /// <param name="substitutes">Indices of objects that may have taken the place of those that are gone.</param>
    private static void Take(CommandContext context, Drawing edited, IReadOnlyList<int> previous, IReadOnlyList<int> hidden, IEnumerable<int> substitutes, Func<DrawingSettings, DrawingSettings>? change = null)
    {
        var state = context.Document.Current;
        var settings = state.Settings with { Enter = EnteringAfter(context, edited, substitutes) };
        if (change is not null) settings = change(settings);
        context.Take(state with { Drawing = edited, Settings = settings, Selection = [], Previous = previous, HiddenObjects = hidden });
    }

    /// <summary>Where cutting begins after an edit: at the object that took the place of the entering entity, of which the operator is told.</summary>
    private static EnteringPlace? EnteringAfter(CommandContext context, Drawing edited, IEnumerable<int> substitutes)
    {
        var place = context.Document.Current.Settings.Enter;
        if (place is not EnteringPlace.ByHandle { Handle: var handle } || edited.IndexOfHandle(handle) is not null) return place;
        if (EnteringSubstitute.HandleOf(context.Drawing, handle, edited, substitutes) is { } other)
        {
            context.Say(Wording.Get("DrawingChange.EnteringEntityReplaced", handle, other));
            return new EnteringPlace.ByHandle(other);
        }

        context.Say(Wording.Get("DrawingChange.EnteringEntityRemoved", handle));
        return null;
    }
}
