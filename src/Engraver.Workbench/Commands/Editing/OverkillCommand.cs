using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>OVERKILL: Erases objects that coincide with others, drawn in either direction.</summary>
internal sealed class OverkillCommand : ICommand
{
    public CommandInfo Info { get; } = new("OVERKILL", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = await ObjectSelection.GetForEditAsync(context).ConfigureAwait(false);
        var now = NumberPrompt.Format(drawing.Scale.ToDrawing(context.Document.Current.Settings.MaxErrorMm));
        var tolerance = await context.ValueAsync(new NumberPrompt(Wording.Get("Overkill.SpecifyTolerance")) { Default = context.LastValue("OVERKILL", now), Min = 0.0, Max = 1e3 }).ConfigureAwait(false);
        context.Remember("OVERKILL", NumberPrompt.Format(tolerance));
        var duplicates = Duplicates.Find(drawing, selected, tolerance);
        if (duplicates.Count > 0) DrawingChange.Erase(context, duplicates, asDoubles: true);
        context.WriteMessage(Wording.Get("Overkill.Erased", CountText.Format(duplicates.Count, "Duplicate")));
    }
}
