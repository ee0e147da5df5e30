using Engraver.Core.Dxf;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands;

/// <summary>SAVEAS: Writes the drawing as edited, as DXF in millimetres: lines, arcs and circles.</summary>
internal sealed class SaveAsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File, "Writes the drawing as edited, as DXF in millimetres: lines, arcs and circles.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        if (EditedDrawing.SheetOf(drawing) is not { } sheet) throw new CommandException(CommandFailure.Drawing, "The drawing has ellipses or splines, which are not written yet as what they are; EXPORT to a .dxf file writes the path that would be cut.");
        var name = await ReplacePrompt.AskAsync(context, "Enter name of DXF file").ConfigureAwait(false);
        OutputFile.Write(context.FileToWrite(name), output => DxfWriter.Write(sheet, output));
        context.Say(FormattableString.Invariant($"{name} written: {sheet.Entities.Count} lines, arcs and circles on {sheet.Layers.Count + 1} layers, millimetres. Polylines are written as their parts; text and the like are not written."));
        if (sheet.Layers.Any(layer => !layer.Plots) && drawing.Layers.Any(layer => layer.Plot && !layer.CutByDefault)) context.Say("Layers that were off or frozen are written as layers that are not plotted.");
    }
}
