using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The columns that store curves, of the drawing or of all blocks together.</summary>
internal sealed class CurveColumns
{
    public GrowingColumn<DrawingEntity> Entities { get; } = new();

    public GrowingColumn<DrawingPart> Parts { get; } = new();

    /// <summary>Ellipses and splines that parts refer to.</summary>
    public List<RationalCurve> Curves { get; } = [];

    public int Count => Entities.Count;

    /// <param name="entity">The row; the position of its parts is filled in here.</param>
    /// <param name="parts">Ellipses and splines refer to <paramref name="curves"/>.</param>
    /// <param name="curves">Ellipses and splines of these parts only.</param>
    public void Add(DrawingEntity entity, ReadOnlySpan<DrawingPart> parts, IReadOnlyList<RationalCurve> curves)
    {
        entity.FirstPart = Parts.Count;
        entity.PartCount = parts.Length;
        var index = Entities.Add(entity);
        foreach (ref readonly var part in parts)
        {
            ref var added = ref Parts[Parts.Add(part)];
            added.Entity = index;
            if (!added.IsFreeCurve) continue;
            Curves.Add(curves[part.CurveIndex]);
            added = DrawingPart.FreeCurve(index, part.Kind, Curves.Count - 1);
        }
    }
}
