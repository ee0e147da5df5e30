using Engraver.Core.Drawings;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands;

/// <summary>PROPERTIES: Says what the selected objects have in common; with nothing selected, what is in the drawing.</summary>
internal sealed class PropertiesCommand : ICommand
{
    public CommandInfo Info { get; } = new("PROPERTIES", CommandGroup.Ask, "Says what the selected objects have in common; with nothing selected, what is in the drawing.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = context.Document.Current.Selection;
        context.SayResult(output =>
        {
            if (selected.Count == 0) DrawingText.Write(output, drawing, DrawingSummary.Of(drawing));
            else EntityText.WriteTogether(drawing, selected, output);
        });
        return Task.CompletedTask;
    }
}
