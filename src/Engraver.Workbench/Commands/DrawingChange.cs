using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>The last act of every command that edits: one document step, nothing selected afterwards.</summary>
internal static class DrawingChange
{
    /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
    public static void Transform(CommandContext context, IReadOnlyList<int> selected, Transform2D map, bool copy)
    {
        var drawing = context.Drawing;
        var fits = copy ? DrawingEdit.TryCopy(drawing, selected, map, out var edited) : DrawingEdit.TryTransform(drawing, selected, map, out edited);
        if (!fits) throw new CommandException(CommandFailure.Usage, "That would move objects out of range; nothing was changed.");
        Take(context, edited, selected);
    }

    /// <summary>Erases objects; those that are hidden keep their places in mind.</summary>
    public static void Erase(CommandContext context, IReadOnlyList<int> erased)
    {
        var gone = erased.Distinct().Order().ToList();
        var hidden = context.Document.Current.HiddenObjects.Except(gone).Select(index => index - BelowIn(gone, index));
        Take(context, DrawingEdit.Erase(context.Drawing, gone), [], [.. hidden]);
    }

    /// <param name="previous">What the command worked on, by its index in the rebuilt drawing.</param>
    public static void Take(CommandContext context, DrawingRebuild rebuilt, IReadOnlyList<int> previous) =>
        Take(context, rebuilt.Finish(), previous, rebuilt.Places(context.Document.Current.HiddenObjects));

    /// <summary>For an edit that leaves every object in its place.</summary>
    /// <param name="previous">What the command worked on, by its index in the edited drawing.</param>
    public static void Take(CommandContext context, Drawing edited, IReadOnlyList<int> previous) => Take(context, edited, previous, context.Document.Current.HiddenObjects);

    public static Drawing WithHidden(Drawing drawing, IEnumerable<int> indices, bool hidden) =>
        drawing with { Entities = drawing.Entities.With(indices.Select(index => (index, drawing.Entities[index] with { Hidden = hidden })), []) };

    private static int BelowIn(List<int> sorted, int index) => ~sorted.BinarySearch(index) is >= 0 and var below ? below : throw new ArgumentOutOfRangeException(nameof(index));

    private static void Take(CommandContext context, Drawing edited, IReadOnlyList<int> previous, IReadOnlyList<int> hidden)
    {
        var state = context.Document.Current;
        var lostEntry = state.Settings.Enter is EnteringPlace.ByHandle { Handle: var handle } && edited.IndexOfHandle(handle) is null;
        if (lostEntry) context.Say("The entering entity is gone; the order is free again.");
        context.Take(state with { Drawing = edited, Settings = lostEntry ? state.Settings with { Enter = null } : state.Settings, Selection = [], Previous = previous, HiddenObjects = hidden });
    }
}
