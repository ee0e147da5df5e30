using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands;

/// <summary>OPEN: Opens a drawing: a DXF of any version.</summary>
internal sealed class OpenCommand : ICommand
{
    public CommandInfo Info { get; } = new("OPEN", CommandGroup.File, "Opens a drawing: a DXF of any version.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new TextPrompt("Enter name of drawing to open")).ConfigureAwait(false);
        var state = context.Document.Current;
        var drawing = DrawingFile.Open(context.FileToRead(name), state.Settings.Unit, cancellation);
        Findings.Say(context, drawing.FileName, drawing.Diagnostics, Severity.Warning);
        if (drawing.HasErrors && drawing.Entities.Count == 0) throw new CommandException(CommandFailure.Drawing, $"{name} was not opened: {drawing.Diagnostics.First(found => found.Severity == Severity.Error).Message}");
        context.Take(new DocumentState { Drawing = drawing, Settings = state.Settings with { Enter = null, Layers = null, SkippedLayers = [] } });
        context.Say(FormattableString.Invariant($"{drawing.Entities.Count} curves on {drawing.Layers.Count} layers, unit {drawing.Unit.Name}."));
    }
}
