using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Writing;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>SAVEAS: Writes the drawing as edited, as DXF: every curve as what it is, with its height, layer and colour, and the texts.</summary>
internal sealed class SaveAsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File, "Writes the drawing as edited, as DXF: every curve as what it is, with its height, layer and colour, and the texts.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        if (DrawingRest.Find(drawing) is { Count: > 0 } rest)
        {
            var types = string.Join(", ", rest.Select(part => FormattableString.Invariant($"{part.Count} {part.Type}")));
            FindingMessages.Say(context, drawing.FileName, [DocumentRules.NotSaved.At(default, rest.Sum(part => part.Count).ToString(CultureInfo.InvariantCulture), types)], Severity.Warning);
        }

        var sheet = EditedDrawing.SheetOf(drawing, context.Document.Current.HiddenObjects);
        var name = await ReplacePrompt.AskAsync(context, "Enter name of DXF file").ConfigureAwait(false);
        OutputFile.Write(context.FileToWrite(name), output => DxfWriter.Write(sheet, output));
        context.Document.MarkKept();
        context.Say(FormattableString.Invariant($"{name} written: {CountText.Format(sheet.Entities.Count, "curve")} and {CountText.Format(sheet.Texts.Count, "text")} on {CountText.Format(sheet.Layers.Count, "layer")}, unit {drawing.Unit.Name}. Blocks are written as their curves and texts."));
    }
}
