using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Files;

/// <summary>OPEN: Opens a drawing: a DXF of any version.</summary>
internal sealed class OpenCommand : ICommand
{
    public CommandInfo Info { get; } = new("OPEN", CommandGroup.File) { ReplacesDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Open.EnterName"), new FileRequest(FileRequest.Drawing, false, ".dxf"))).ConfigureAwait(false);
        DrawingOpening.Open(context, name, context.ResolveInputPath(name), cancellation);
    }
}
