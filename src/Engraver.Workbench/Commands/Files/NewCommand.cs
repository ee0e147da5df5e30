using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>NEW: Creates an empty drawing, in millimetres unless another unit is set. It gets a file when it is saved. The operator is asked first whether
/// edits of the open drawing are saved; in a script UNDO restores them.</summary>
internal sealed class NewCommand : ICommand
{
    public CommandInfo Info { get; } = new("NEW", CommandGroup.File) { BringsDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var document = context.Document;
        if (context.IsWatched && document.IsEdited && await context.ChoiceAsync(Wording.Get("New.SaveFirst", Path.GetFileName(document.FilePath)), Keyword.List("Yes", "No"), "Yes").ConfigureAwait(false) == "Yes")
        {
            await QSaveCommand.SaveAsync(context, mayReplace: true).ConfigureAwait(false);
        }

        DrawingBeginning.Begin(context);
    }
}

/// <summary>Creates empty drawings for NEW and for drawing commands without an open drawing.</summary>
internal static class DrawingBeginning
{
    /// <summary>Initial view of an empty drawing: A3 landscape, as in AutoCAD's metric template.</summary>
    private const double SheetWidth = 420.0;

    private const double SheetHeight = 297.0;

    private const int Millimetres = 4;

    /// <summary>Creates a drawing if none is open.</summary>
    public static void Ensure(CommandContext context)
    {
        if (context.Document.Current.Drawing is null) Begin(context);
    }

    /// <summary>One undo step; an open drawing is closed as by OPEN.</summary>
    public static void Begin(CommandContext context)
    {
        DrawingOpening.Leave(context);
        var before = context.Document.Current;
        var settings = before.Settings with { Enter = null, Layers = null, SkippedLayers = [] };
        var unit = settings.Unit ?? LengthUnits.FromInsUnits(Millimetres)!;
        var drawing = Drawing.Empty(Wording.Get("New.FileName", context.Document.CountBegun()), unit, new Layer(CurrentLayer.First, On: true, Frozen: false, Plot: true));
        context.Take(new DocumentState { Drawing = drawing, Settings = settings, Sidecar = DrawingSaving.WithSettingsOf(before.Sidecar) });
        context.Document.MarkOpened();
        context.View.SetCentre(new Point2D(SheetWidth / 2.0, SheetHeight / 2.0), SheetHeight);
        context.Say(Wording.Get("New.Created", drawing.FileName, unit.Name));
    }
}
