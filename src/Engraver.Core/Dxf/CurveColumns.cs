using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>The two columns into which curves go, of the drawing or of all blocks together.</summary>
internal sealed class CurveColumns
{
    public GrowingColumn<DrawingEntity> Entities { get; } = new();

    public GrowingColumn<DrawingPart> Parts { get; } = new();

    public int Count => Entities.Count;

    public void Add(DrawingEntity entity, ReadOnlySpan<DrawingPart> parts)
    {
        entity.FirstPart = Parts.Count;
        entity.PartCount = parts.Length;
        var index = Entities.Add(entity);
        foreach (ref readonly var part in parts)
        {
            ref var added = ref Parts[Parts.Add(part)];
            added.Entity = index;
        }
    }
}
