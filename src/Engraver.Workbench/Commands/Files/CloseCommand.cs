using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>CLOSE: Closes the drawing; UNDO opens it again unchanged.</summary>
internal sealed class CloseCommand : ICommand
{
    public CommandInfo Info { get; } = new("CLOSE", CommandGroup.File) { ReplacesDrawing = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        DrawingOpening.Close(context);
        var state = context.Document.Current;
        context.Commit(new DocumentState { Settings = state.Settings with { Enter = null, Operations = null, Tool = 0 }, Sidecar = DrawingSaving.WithSettingsOf(state.Sidecar) });
        return Task.CompletedTask;
    }
}
