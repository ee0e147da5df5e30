using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing from a file. Whatever stands there, the answer is a drawing; what is wrong with it is among its diagnostics.</summary>
public static class DrawingFile
{
    public static Drawing Open(string path, LengthUnit? unit, CancellationToken cancellation)
    {
        var options = new DxfReadOptions { UnitOverride = unit };
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
