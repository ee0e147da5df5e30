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
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        if (DrawingRest.Find(drawing) is { Count: > 0 } rest)
        {
            var types = string.Join(", ", rest.Select(part => FormattableString.Invariant($"{part.Count} {part.Type}")));
            FindingMessages.Say(context, drawing.FileName, [DocumentRules.NotSaved.At(default, rest.Sum(part => part.Count).ToString(CultureInfo.InvariantCulture), types)], Severity.Warning);
        }

        var sheet = EditedDrawing.SheetOf(drawing, context.Document.Current.HiddenObjects);
        var name = await ReplacePrompt.AskAsync(context, Wording.Get("SaveAs.EnterNameDxfFile")).ConfigureAwait(false);
        OutputFile.Write(context.FileToWrite(name), output => DxfWriter.Write(sheet, output));
        context.Document.MarkKept();
        context.Say(Wording.Get("SaveAs.WrittenOnUnitBlocks", name, CountText.Format(sheet.Entities.Count, "Curve"), CountText.Format(sheet.Texts.Count, "Text"), CountText.Format(sheet.Layers.Count, "Layer"), drawing.Unit.Name));
    }
}
