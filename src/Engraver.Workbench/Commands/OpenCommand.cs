using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>OPEN: Opens a drawing: a DXF of any version.</summary>
internal sealed class OpenCommand : ICommand
{
    public CommandInfo Info { get; } = new("OPEN", CommandGroup.File, "Opens a drawing: a DXF of any version.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new TextPrompt("Enter name of drawing to open")).ConfigureAwait(false);
        DrawingOpening.Open(context, name, context.FileToRead(name), cancellation);
    }
}
