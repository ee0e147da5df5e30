using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>MOVE: Moves objects.</summary>
internal sealed class MoveCommand : ICommand
{
    public CommandInfo Info { get; } = new("MOVE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        DrawingChange.Transform(context, selected, Transform2D.Move(await DisplacementPrompts.AskAsync(context, new SelectionGhost(context.Drawing, selected)).ConfigureAwait(false)), copy: false);
    }
}
