using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>JOIN: Joins lines, arcs and open polylines whose ends meet (within CNCJOINTOL) to polylines.</summary>
internal sealed class JoinCommand : ICommand
{
    public CommandInfo Info { get; } = new("JOIN", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = await ObjectSelection.GetForEditAsync(context).ConfigureAwait(false);
        var tolerance = drawing.Scale.ToDrawing(context.Document.Current.Settings.JoinToleranceMm);
        var (rebuilt, joined, count) = PolylineEdit.Join(drawing, selected, tolerance);
        if (count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Join.NoCommonEnds"));
        DrawingChange.Commit(context, rebuilt, joined);
        context.WriteMessage(Wording.Get("Editing.Converted", CountText.Format(count, "Object"), CountText.Format(joined.Count, "Polyline")));
    }
}
