using Engraver.Core.Drawings;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>PROPERTIES: Shows the common properties of the selected objects; without a selection a summary of the drawing.</summary>
internal sealed class PropertiesCommand : ICommand
{
    public CommandInfo Info { get; } = new("PROPERTIES", CommandGroup.Ask) { HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = context.Document.Current.Selection;
        context.SayResult(output =>
        {
            if (selected.Count == 0) DrawingText.Write(output, drawing, DrawingSummary.From(drawing));
            else EntityText.WriteTogether(drawing, selected, context.Figures, output);
        });
        return Task.CompletedTask;
    }
}

/// <summary>LIST: Lists the selected objects with handle, layer, coordinates and length.</summary>
internal sealed class ListCommand : ICommand
{
    public CommandInfo Info { get; } = new("LIST", CommandGroup.Ask) { HeardDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        context.SayResult(output => EntityText.Write(drawing, selected, context.Figures, output));
    }
}
