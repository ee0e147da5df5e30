using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing from a file. Whatever stands there, the answer is a drawing; what is wrong with it is among its diagnostics.</summary>
public static class DrawingFile
{
    public static Drawing Open(string path, LengthUnit? unit, CancellationToken cancellation) => Open(path, new DxfReadOptions { UnitOverride = unit }, cancellation);

    /// <summary>The same with everything of the settings that changes what is read.</summary>
    public static Drawing Open(string path, DrawingSettings settings, CancellationToken cancellation) =>
        Open(path, new DxfReadOptions { UnitOverride = settings.Unit, Cut = settings.Cut }, cancellation);

    private static Drawing Open(string path, DxfReadOptions options, CancellationToken cancellation)
    {
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
