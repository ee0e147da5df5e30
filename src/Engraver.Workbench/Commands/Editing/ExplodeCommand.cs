using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>EXPLODE: Splits polylines into lines and arcs.</summary>
internal sealed class ExplodeCommand : ICommand
{
    public CommandInfo Info { get; } = new("EXPLODE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context).ConfigureAwait(false);
        var (rebuilt, parts, count) = PolylineEdit.Explode(context.Drawing, selected);
        if (count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Explode.NoPolyline"));
        DrawingChange.Commit(context, rebuilt, parts);
        context.WriteMessage(Wording.Get("Editing.Converted", CountText.Format(count, "Polyline"), CountText.Format(parts.Count, "Object")));
    }
}
