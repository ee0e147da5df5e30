using Engraver.Core.Drawings;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>REVERSE: Reverses the direction of objects.</summary>
internal sealed class ReverseCommand : ICommand
{
    public CommandInfo Info { get; } = new("REVERSE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var selected = await ObjectSelection.GetForEditAsync(context).ConfigureAwait(false);
        DrawingChange.Commit(context, DrawingEdit.Reverse(drawing, selected), selected);
    }
}
