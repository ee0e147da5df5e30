using Engraver.Core.Diagnostics;

namespace Engraver.Core.Drawings;

/// <summary>A drawing as read: every curve of model space after block expansion, in drawing units, as columns. Immutable once built.</summary>
public sealed record Drawing(
    string FileName,
    long Bytes,
    string DxfVersion,
    string Encoding,
    LengthUnit Unit,
    IReadOnlyList<Layer> Layers,
    GrowingColumn<DrawingEntity> Entities,
    GrowingColumn<DrawingPart> Parts,
    DrawingBalance Balance,
    IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>True when a diagnostic of severity error stands against the drawing (exit code 1; a job does not start without consent).</summary>
    public bool HasErrors => Diagnostics.Any(d => d.Severity == Severity.Error);

    public SourceRef SourceOf(int entityIndex)
    {
        ref var entity = ref Entities[entityIndex];
        return new SourceRef(entity.SourceLine, entity.Handle == 0 ? null : entity.Handle.ToString("X", System.Globalization.CultureInfo.InvariantCulture));
    }
}
