using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Creates empty drawings for NEW and for drawing commands without an open drawing.</summary>
internal static class NewDrawing
{
    /// <summary>Initial view of an empty drawing: A3 landscape, as in AutoCAD's metric template.</summary>
    private const double SheetWidth = 420.0;

    private const double SheetHeight = 297.0;

    private const int Millimetres = 4;

    /// <summary>Creates a drawing if none is open.</summary>
    public static void EnsureOpen(CommandContext context)
    {
        if (context.Document.Current.Drawing is null) Create(context);
    }

    /// <summary>One undo step; an open drawing is closed as by OPEN.</summary>
    public static void Create(CommandContext context)
    {
        DrawingOpening.Close(context);
        var before = context.Document.Current;
        var settings = before.SettingsOfNext;
        var unit = settings.Unit ?? LengthUnits.FromInsUnits(Millimetres)!;
        var drawing = Drawing.Empty(Wording.Get("New.FileName", context.Document.NextDrawingNumber()), unit, new Layer(CurrentLayer.DefaultName, On: true, Frozen: false, Plot: true));
        context.Commit(new DocumentState { Drawing = drawing, Settings = settings, Sidecar = DrawingSaving.WithSettingsOf(before.Sidecar) });
        context.Document.MarkOpened();
        context.View.SetCentre(new Point2D(SheetWidth / 2.0, SheetHeight / 2.0), SheetHeight);
        context.WriteMessage(Wording.Get("New.Created", drawing.FileName, unit.Name));
    }
}
