using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>OPEN: Opens a drawing: a DXF of any version.</summary>
internal sealed class OpenCommand : ICommand
{
    public CommandInfo Info { get; } = new("OPEN", CommandGroup.File) { BringsDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Open.EnterName"), new FileWanted(FileWanted.Drawing, false, ".dxf"))).ConfigureAwait(false);
        DrawingOpening.Open(context, name, context.FileToRead(name), cancellation);
    }
}

/// <summary>CLOSE: Closes the drawing; UNDO opens it again unchanged.</summary>
internal sealed class CloseCommand : ICommand
{
    public CommandInfo Info { get; } = new("CLOSE", CommandGroup.File) { BringsDrawing = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        DrawingOpening.Leave(context);
        var state = context.Document.Current;
        context.Take(new DocumentState { Settings = state.Settings with { Enter = null }, Sidecar = DrawingSaving.WithSettingsOf(state.Sidecar) });
        return Task.CompletedTask;
    }
}
