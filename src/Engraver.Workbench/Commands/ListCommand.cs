using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands;

/// <summary>LIST: Says what the selected objects are, with handle, layer, coordinates and length.</summary>
internal sealed class ListCommand : ICommand
{
    public CommandInfo Info { get; } = new("LIST", CommandGroup.Ask, "Says what the selected objects are, with handle, layer, coordinates and length.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        context.SayResult(output => EntityText.Write(drawing, selected, output));
    }
}
