using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands;

/// <summary>CLOSE: Closes the drawing; UNDO opens it again as it was.</summary>
internal sealed class CloseCommand : ICommand
{
    public CommandInfo Info { get; } = new("CLOSE", CommandGroup.File, "Closes the drawing; UNDO opens it again as it was.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        DrawingOpening.Leave(context);
        var state = context.Document.Current;
        context.Take(new DocumentState { Settings = state.Settings with { Enter = null } });
        return Task.CompletedTask;
    }
}
