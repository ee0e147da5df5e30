using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Languages;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>Reads a drawing from a file. Always returns a drawing; errors in the file are diagnostics.</summary>
public static class DrawingFile
{
    /// <param name="settings">Only the unit, the cut choice and the placement are used.</param>
    /// <param name="progress">Receives the fraction read, 0 to 1; null for none.</param>
    /// <returns>Placed; its findings name places in the coordinates of the file.</returns>
    public static Drawing Open(string path, DrawingSettings settings, CancellationToken cancellation, IProgress<double>? progress = null) =>
        PlacedDrawing.Of(Open(path, new DxfReadOptions { UnitOverride = settings.Unit, Cut = settings.Cut, Areas = settings.Operations?.Areas ?? CutChoice.None, Progress = progress }, cancellation), settings);

    /// <summary>True if no part of the file could be read. Results of an earlier drawing must then not be overwritten with empty ones.</summary>
    public static bool IsUnreadable(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing is { HasErrors: true, Entities.Count: 0, Texts.Count: 0 };
    }

    private static Drawing Open(string path, DxfReadOptions options, CancellationToken cancellation)
    {
        if (Directory.Exists(path)) return Drawing.Unusable(path, 0, DocumentRules.Unreadable.At(default, Wording.Get("DrawingFile.Folder")));
        try
        {
            using var arriving = ProgressiveFile.TryStart(path);
            using var ended = cancellation.Register(() => arriving?.Dispose());
            return arriving is null ? DxfReader.Read(File.ReadAllBytes(path), path, options, cancellation) : DxfReader.Read(arriving, path, options, cancellation);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            cancellation.ThrowIfCancellationRequested();
            return Drawing.Unusable(path, 0, DocumentRules.Unreadable.At(default, SystemErrorText.FromException(unreadable)));
        }
    }
}
