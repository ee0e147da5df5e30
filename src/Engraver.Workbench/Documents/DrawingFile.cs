using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing from a file. Whatever stands there, the answer is a drawing; what is wrong with it is among its diagnostics.</summary>
public static class DrawingFile
{
    /// <param name="settings">Of these only what changes what is read: the unit, what else is to be cut.</param>
    /// <param name="progress">Is told how much has been read, 0 to 1; null: nobody.</param>
    public static Drawing Open(string path, DrawingSettings settings, CancellationToken cancellation, IProgress<double>? progress = null) =>
        Open(path, new DxfReadOptions { UnitOverride = settings.Unit, Cut = settings.Cut, Progress = progress }, cancellation);

    /// <summary>Nothing of it could be read. Whatever an earlier drawing was made into must then not be replaced by nothing.</summary>
    public static bool IsUnreadable(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing is { HasErrors: true, Entities.Count: 0 };
    }

    private static Drawing Open(string path, DxfReadOptions options, CancellationToken cancellation)
    {
        if (Directory.Exists(path)) return Drawing.Unusable(path, 0, DocumentRules.Unreadable.At(default, Wording.Get("DrawingFile.Folder")));
        try
        {
            return DxfReader.Read(File.ReadAllBytes(path), path, options, cancellation);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return Drawing.Unusable(path, 0, DocumentRules.Unreadable.At(default, unreadable.Message.TrimEnd('.')));
        }
    }
}
