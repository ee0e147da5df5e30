using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Builds a drawing in which some objects are replaced by pieces of themselves; the first piece keeps the handle.</summary>
internal sealed class ReshapedDrawing
{
    private readonly Drawing _drawing;
    private readonly Dictionary<int, IReadOnlyList<IReadOnlyList<PathRange>>> _shapes = [];
    private readonly Dictionary<int, List<int>> _places = [];
    private readonly List<(int Like, int Layer, Segment Segment)> _added = [];

    public ReshapedDrawing(Drawing drawing) => _drawing = drawing;

    /// <summary>The unchanged drawing.</summary>
    public Drawing Drawing => _drawing;

    /// <summary>Number of objects with a new shape.</summary>
    public int Count => _shapes.Count;

    /// <summary>Replaces an object by these pieces; an empty list erases it.</summary>
    public void Set(int entity, IReadOnlyList<IReadOnlyList<PathRange>> kept) => _shapes[entity] = kept;

    /// <summary>Appends a line or an arc.</summary>
    /// <param name="like">Object with the colour and height to copy.</param>
    /// <param name="layer">Index of its layer.</param>
    public void Add(int like, int layer, Segment segment) => _added.Add((like, layer, segment));

    public DrawingRebuild Build()
    {
        var rebuilt = new DrawingRebuild(_drawing);
        for (var index = 0; index < _drawing.Entities.Count; index++)
        {
            if (_shapes.TryGetValue(index, out var kept)) _places[index] = [.. kept.Select((pieces, number) => Append(rebuilt, index, pieces, isFirst: number == 0))];
            else rebuilt.Keep(index);
        }

        foreach (var (like, layer, segment) in _added)
        {
            var part = _drawing.Parts[_drawing.Entities[like].FirstPart];
            var height = part.IsFreeCurve ? 0.0 : part.C;
            rebuilt.Add(_drawing.Entities[like] with { Layer = layer }, segment.Kind == SegmentKind.Line ? CurveType.Line : CurveType.Arc, closed: false, [PartOf(segment, height)]);
        }

        return rebuilt;
    }

    /// <summary>New indices of objects and of the pieces of divided ones. Call after <see cref="Build"/>.</summary>
    public IReadOnlyList<int> Places(DrawingRebuild rebuilt, IEnumerable<int> entities) => [.. entities.SelectMany(entity => _places.GetValueOrDefault(entity) ?? rebuilt.NewIndices([entity]))];

    /// <summary>The object as a path; null if it cannot be cut (no parts, or a part without length).</summary>
    public static EntityPath? PathOf(Drawing drawing, int entity)
    {
        Segment[] parts = [.. DrawingPick.Segments(drawing, entity)];
        return parts.Length == 0 || Array.Exists(parts, part => part is { Kind: SegmentKind.Line, Length: 0.0 }) ? null : new EntityPath(parts, drawing.Entities[entity].Closed || (parts.Length == 1 && parts[0].IsClosed));
    }

    /// <summary>A part in plan at a height.</summary>
    public static DrawingPart PartOf(in Segment segment, double height) => segment.Kind == SegmentKind.Line
        ? DrawingPart.Line(0, segment.Start.X, segment.Start.Y, height, segment.End.X, segment.End.Y, height)
        : DrawingPart.Arc(0, segment.Arc, height);

    /// <summary>A piece of a line, arc or circle; an inclined line keeps its slope.</summary>
    /// <param name="whole">The whole part.</param>
    /// <param name="segment">The piece in plan.</param>
    public static DrawingPart PartOf(in DrawingPart whole, in PathRange piece, in Segment segment)
    {
        if (whole.Kind != SegmentKind.Line) return DrawingPart.Arc(0, segment.Arc, whole.C);
        var rise = whole.F - whole.C;
        return DrawingPart.Line(0, segment.Start.X, segment.Start.Y, whole.C + (rise * piece.From), segment.End.X, segment.End.Y, whole.C + (rise * piece.To));
    }

    private int Append(DrawingRebuild rebuilt, int index, IReadOnlyList<PathRange> pieces, bool isFirst)
    {
        var entity = _drawing.Entities[index];
        var parts = pieces.Select(piece => PartOf(rebuilt, _drawing.Parts[entity.FirstPart + piece.Part], piece)).ToList();
        var type = entity.Type == CurveType.Circle && parts[0].Kind == SegmentKind.Arc ? CurveType.Arc : entity.Type;
        var place = rebuilt.Count;
        if (isFirst) rebuilt.Change(index, type, closed: false, parts);
        else rebuilt.Add(entity, type, closed: false, parts);
        return place;
    }

    private DrawingPart PartOf(DrawingRebuild rebuilt, in DrawingPart part, in PathRange piece)
    {
        var segment = piece.Of(_drawing.SegmentOf(part));
        return part.IsFreeCurve ? rebuilt.PartOf(segment.Curve) : PartOf(part, piece, segment);
    }
}
