using Engraver.Core.Drawings;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>PROPERTIES: Shows the common properties of the selected objects; without a selection a summary of the drawing.</summary>
internal sealed class PropertiesCommand : ICommand
{
    public CommandInfo Info { get; } = new("PROPERTIES", CommandGroup.Ask) { IsAllowedDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = context.Document.Current.Selection;
        context.WriteResult(output =>
        {
            if (selected.Count == 0) DrawingText.Write(output, drawing, DrawingSummary.From(drawing));
            else EntityText.WriteTogether(drawing, selected, context.Precision, output);
        });
        return Task.CompletedTask;
    }
}
