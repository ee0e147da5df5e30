using Engraver.Core.Drawings;

namespace Engraver.Workbench.Documents;

/// <summary>Builds a drawing from an old one, entity by entity: entities are kept, replaced or added. New ones get handles above the highest of the
/// drawing.</summary>
internal sealed class DrawingRebuild
{
    private readonly Drawing _drawing;
    private readonly GrowingColumn<DrawingEntity> _entities = new();
    private readonly GrowingColumn<DrawingPart> _parts = new();
    private readonly Dictionary<int, int> _newIndices = [];
    private readonly List<Core.Geometry.RationalCurve> _curves = [];
    private ulong _handle;

    public DrawingRebuild(Drawing drawing) => (_drawing, _handle) = (drawing, drawing.HighestHandle());

    /// <summary>Number of entities so far, which is the index of the next one.</summary>
    public int Count => _entities.Count;

    /// <summary>Copies an entity unchanged.</summary>
    public void Keep(int index)
    {
        _newIndices[index] = Count;
        Append(_drawing.Entities[index], PartsOf(_drawing, index));
    }

    /// <summary>Adds a new entity.</summary>
    /// <param name="like">Entity whose layer and source line are copied.</param>
    public void Add(in DrawingEntity like, CurveType type, bool closed, IReadOnlyList<DrawingPart> parts) =>
        Append(like with { Type = type, Closed = closed, Handle = ++_handle, PartCount = parts.Count }, parts);

    /// <summary>Copies an entity with a new shape; it keeps its handle.</summary>
    public void Change(int index, CurveType type, bool closed, IReadOnlyList<DrawingPart> parts)
    {
        _newIndices[index] = Count;
        Append(_drawing.Entities[index] with { Type = type, Closed = closed, PartCount = parts.Count }, parts);
    }

    /// <summary>A part for an ellipse or spline that the old drawing does not have.</summary>
    public DrawingPart PartOf(Core.Geometry.RationalCurve curve)
    {
        _curves.Add(curve);
        return DrawingPart.FreeCurve(0, curve.Kind, _drawing.Curves.Count + _curves.Count - 1);
    }

    /// <summary>The curve of a part of the old drawing or of a new part.</summary>
    public Core.Geometry.RationalCurve CurveOf(in DrawingPart part) => part.CurveIndex < _drawing.Curves.Count ? _drawing.Curves[part.CurveIndex] : _curves[part.CurveIndex - _drawing.Curves.Count];

    /// <summary>New indices of entities of the old drawing, without replaced ones.</summary>
    public IReadOnlyList<int> NewIndices(IEnumerable<int> indices) => [.. indices.Where(_newIndices.ContainsKey).Select(index => _newIndices[index])];

    public Drawing Finish() => _drawing with { Entities = _entities, Parts = _parts, Curves = _curves.Count == 0 ? _drawing.Curves : [.. _drawing.Curves, .. _curves] };

    public static List<DrawingPart> PartsOf(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        return [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.Parts[part])];
    }

    private void Append(DrawingEntity entity, IReadOnlyList<DrawingPart> parts)
    {
        entity.FirstPart = _parts.Count;
        foreach (var part in parts) _parts.Add(part with { Entity = Count });
        _entities.Add(entity);
    }
}
