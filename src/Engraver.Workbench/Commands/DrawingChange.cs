using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
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

    /// <param name="previous">What the command worked on, by its index in the edited drawing.</param>
    public static void Take(CommandContext context, Drawing edited, IReadOnlyList<int> previous)
    {
        var state = context.Document.Current;
        var lostEntry = state.Settings.Enter is EnteringPlace.ByHandle { Handle: var handle } && edited.IndexOfHandle(handle) is null;
        if (lostEntry) context.Say("The entering entity is gone; the order is free again.");
        context.Take(state with { Drawing = edited, Settings = lostEntry ? state.Settings with { Enter = null } : state.Settings, Selection = [], Previous = previous });
    }
}
