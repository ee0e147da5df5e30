using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;

namespace Engraver.Core.Operations;

/// <summary>The points and inserts of a drawing that may be drilled, and their entities, which are added behind those of the drawing when they are
/// drilled.</summary>
internal sealed class PlacedContent
{
    private readonly Drawing _drawing;
    private readonly int _reserved;
    private readonly Dictionary<(bool IsPoint, int Index), int> _entities = [];
    private readonly List<DrawingEntity> _added = [];
    private readonly Lazy<Dictionary<int, int>> _firstCurves;

    /// <param name="analysed">The rows of the layers that are cut.</param>
    /// <param name="layers">For each layer, true when it is cut.</param>
    /// <param name="reserved">Indices below this one are those of other entities.</param>
    public PlacedContent(Drawing drawing, EntityTable analysed, bool[] layers, int reserved)
    {
        (_drawing, _reserved) = (drawing, Math.Max(reserved, drawing.Entities.Count));
        _firstCurves = new(() => FirstCurves(drawing));
        var cut = InsertsOf(drawing, analysed);
        Points = [.. Enumerable.Range(0, drawing.Points.Count).Where(point => !drawing.Points[point].Hidden && layers[drawing.Points[point].Layer])];
        Inserts = [.. Enumerable.Range(0, drawing.Inserts.Count).Where(insert => drawing.Inserts[insert] is { Hidden: false, IsErased: false } placed && (layers[placed.Layer] || cut.Contains(insert + 1)))];
    }

    /// <summary>Indices of the visible points on layers that are cut.</summary>
    public IReadOnlyList<int> Points { get; }

    /// <summary>Indices of the visible inserts that are on a layer that is cut, or have a curve that is cut.</summary>
    public IReadOnlyList<int> Inserts { get; }

    public DrillPlace AtPoint(int index)
    {
        var point = _drawing.Points[index];
        return new DrillPlace(_drawing.Scale.ToMillimetres(point.Plan), EntityOf((true, index), () => new DrawingEntity { SourceLine = point.SourceLine, Handle = point.Handle, Layer = point.Layer, Colour = point.Colour, Type = CurveType.Point }));
    }

    /// <summary>The insertion point; its entity is the first curve of the insert, if it has one.</summary>
    public DrillPlace AtInsert(int index)
    {
        var insert = _drawing.Inserts[index];
        var entity = _firstCurves.Value.TryGetValue(index + 1, out var first) ? first : EntityOf((false, index), () => new DrawingEntity { Layer = insert.Layer, Type = CurveType.Insert });
        return new DrillPlace(_drawing.Scale.ToMillimetres(insert.Plan), entity);
    }

    /// <summary>The drawing with an entity without parts for each place that has none of its own, and without the points and hatches that belong to operations
    /// in its construction.</summary>
    /// <param name="points">Indices of these points.</param>
    /// <param name="areas">Indices of the outlines of these hatches.</param>
    public Drawing ToDrawing(IReadOnlyList<int> points, IReadOnlyList<int> areas)
    {
        var hatches = areas.Select(area => _drawing.Entities[area]).DistinctBy(area => (area.SourceLine, area.Insert)).Select(area => (Type: area.Type.ToDxfName(), area.Layer));
        var counts = points.Select(point => (Type: CurveType.Point.ToDxfName(), _drawing.Points[point].Layer)).Concat(hatches).GroupBy(one => one).ToDictionary(group => group.Key, group => group.Count());
        var drawing = counts.Count == 0 ? _drawing : _drawing with
        {
            Construction = [.. _drawing.Construction.Select(one => counts.TryGetValue((one.Type, one.Layer), out var taken) ? one with { Count = one.Count - taken } : one).Where(one => one.Count > 0)],
        };
        if (_added.Count == 0) return drawing;
        var rows = Enumerable.Repeat(new DrawingEntity { Type = CurveType.Point }, _reserved - _drawing.Entities.Count).Concat(_added).Select(entity =>
        {
            entity.FirstPart = _drawing.Parts.Count;
            return entity;
        });
        return drawing with { Entities = drawing.Entities.With([], rows) };
    }

    private int EntityOf((bool, int) key, Func<DrawingEntity> create)
    {
        if (_entities.TryGetValue(key, out var known)) return known;
        _added.Add(create());
        return _entities[key] = _reserved + _added.Count - 1;
    }

    private static HashSet<int> InsertsOf(Drawing drawing, EntityTable analysed)
    {
        var inserts = new HashSet<int>();
        for (var row = 0; row < analysed.Count && drawing.Inserts.Count > 0; row++)
        {
            for (var number = drawing.Entities[analysed.EntityIndexOf(row)].Insert; number > 0 && inserts.Add(number); number = drawing.Inserts[number - 1].Around)
            {
            }
        }

        return inserts;
    }

    private static Dictionary<int, int> FirstCurves(Drawing drawing)
    {
        var first = new Dictionary<int, int>();
        for (var entity = 0; entity < drawing.Entities.Count; entity++)
        {
            for (var number = drawing.Entities[entity].Insert; number > 0 && first.TryAdd(number, entity); number = drawing.Inserts[number - 1].Around)
            {
            }
        }

        return first;
    }
}
