using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Kerf;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Opens a file for OPEN and RECENT: commits one undo step, restores the last view of the file (otherwise shows all), and adds the file to the recent
/// ones.</summary>
internal static class DrawingOpening
{
    /// <param name="name">As typed.</param>
    /// <param name="wanted">Settings of an earlier job; null for the current ones without those specific to another drawing.</param>
    /// <exception cref="CommandException">The file could not be read.</exception>
    public static void Open(CommandContext context, string name, string path, CancellationToken cancellation, DrawingSettings? wanted = null)
    {
        var settings = wanted ?? context.Document.Current.SettingsOfNext;
        var drawing = context.Document.ShareColumns(Read(context, path, settings, cancellation));
        var why = DrawingFile.IsUnreadable(drawing) ? drawing.Diagnostics.First(found => found.Severity == Severity.Error) : null;
        FindingMessages.Write(context, drawing.FileName, why is null ? drawing.Diagnostics : [.. drawing.Diagnostics.Where(found => found != why)], Severity.Warning);
        if (why is not null) throw new CommandException(CommandFailure.Drawing, Wording.Get("DrawingOpening.NotOpened", name, SettingWording.AtCommandLine(why).Message));
        Close(context);
        var sidecar = DrawingSaving.LoadSidecar(context, drawing);
        var operations = wanted is null ? sidecar.Operations : wanted.Operations;
        context.Commit(new DocumentState { Drawing = drawing, Settings = operations is null ? settings : settings with { Operations = operations, Kerf = KerfSide.Off }, Sidecar = sidecar });
        context.Document.MarkOpened();
        context.Settings.Change(kept => kept.WithRecent(Path.GetFullPath(path)));
        Show(context, drawing);
        context.WriteMessage(Wording.Get("DrawingOpening.Contents", CountText.Format(drawing.Entities.Count, "Curve"), CountText.Format(drawing.Layers.Count, "Layer"), drawing.Unit.Name));
        if (operations is not null && settings.Kerf != KerfSide.Off) context.WriteMessage(Wording.Get("DrawingOpening.KerfOff"));
        if (operations is not null) context.WriteMessage(Wording.Get("DrawingOpening.Operations", operations.Operations.Count));
        if (sidecar.Trajectories.All.Count is > 0 and var count) context.WriteMessage(Wording.Get("DrawingOpening.Trajectories", CountText.Format(count, "Trajectory")));
    }

    /// <summary>Saves the view of the drawing being closed, and warns about unsaved edits.</summary>
    public static void Close(CommandContext context)
    {
        if (context.Document.Current.Drawing is not { } drawing) return;
        if (context.Document.IsEdited) context.WriteMessage(Wording.Get("DrawingOpening.UnsavedChanges", Path.GetFileName(context.Document.FilePath)), MessageKind.Warning);
        var path = Path.GetFullPath(drawing.FileName);
        if (!context.Settings.Current.RecentFiles.Contains(path)) return;
        var view = context.View.Current;
        context.Settings.Change(settings => settings.WithView(path, new SavedView(view.Centre.X, view.Centre.Y, view.Height)));
    }

    private static Drawing Read(CommandContext context, string path, DrawingSettings settings, CancellationToken cancellation)
    {
        try
        {
            return DrawingFile.Open(path, settings, cancellation, context.Progress);
        }
        finally
        {
            context.Progress.End();
        }
    }

    private static void Show(CommandContext context, Drawing drawing)
    {
        if (context.Settings.Current.Views.GetValueOrDefault(Path.GetFullPath(drawing.FileName)) is { Height: > 0.0 } saved) context.View.SetCentre(new(saved.CentreX, saved.CentreY), saved.Height);
        else context.View.ZoomExtents(drawing);
    }
}
