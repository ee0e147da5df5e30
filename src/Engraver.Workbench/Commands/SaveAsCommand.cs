using Engraver.Core.Dxf;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands;

/// <summary>SAVEAS: Writes the drawing as edited, as DXF: every curve as what it is, with its layer and colour.</summary>
internal sealed class SaveAsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File, "Writes the drawing as edited, as DXF: every curve as what it is, with its layer and colour.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var sheet = EditedDrawing.SheetOf(drawing, context.Document.Current.HiddenObjects);
        var name = await ReplacePrompt.AskAsync(context, "Enter name of DXF file").ConfigureAwait(false);
        OutputFile.Write(context.FileToWrite(name), output => DxfWriter.Write(sheet, output));
        context.Say(FormattableString.Invariant($"{name} written: {CountText.Of(sheet.Entities.Count, "curve")} on {CountText.Of(sheet.Layers.Count, "layer")}, unit {drawing.Unit.Name}. Blocks are written as their curves, flat; text and the like are not written."));
    }
}
