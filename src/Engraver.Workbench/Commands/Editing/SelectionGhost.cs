using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>Preview of the selected objects at the cursor, drawing units. A large selection is shown as its bounding box and a sample of its segments to limit
/// the cost of each mouse move.</summary>
internal sealed class SelectionGhost
{
    /// <summary>Maximum number of segments of a preview, over all copies.</summary>
    public const int MaxSegments = 1000;

    /// <summary>Maximum number of texts that are shown with the direction that they will have.</summary>
    private const int MaxTexts = 50;

    private readonly Drawing _drawing;
    private readonly IReadOnlyList<int> _selected;
    private SelectionGhost? _curves;
    private readonly Lazy<Segment[]> _shown;
    private readonly Lazy<Segment[]> _box;

    public SelectionGhost(Drawing drawing, IReadOnlyList<int> selected)
    {
        (_drawing, _selected) = (drawing, selected);
        _box = new Lazy<Segment[]>(() => BoxOf(ShownDrawing.Of(drawing), selected));
        _shown = new Lazy<Segment[]>(() => Sample(ShownDrawing.Of(drawing), selected));
    }

    /// <summary>The transformed objects.</summary>
    public IReadOnlyList<Segment> Mapped(Transform2D map) => Mapped([map]);

    /// <summary>The objects mirrored, their texts as MIRROR leaves them.</summary>
    /// <param name="keepsTexts">Texts stay readable.</param>
    public IReadOnlyList<Segment> Mirrored(Transform2D map, bool keepsTexts)
    {
        int[] texts = keepsTexts ? [.. _selected.Where(index => index >= _drawing.Entities.Count)] : [];
        if (texts.Length is 0 or > MaxTexts) return Mapped(map);
        _curves ??= new SelectionGhost(_drawing, [.. _selected.Where(index => index < _drawing.Entities.Count)]);
        var shown = ShownDrawing.Of(_drawing);
        return [.. _curves.Mapped(map), .. texts.SelectMany(index => DrawingPick.Segments(shown, index).Select(letter => letter.Mapped(EditedAnnotations.Readable(_drawing, index - _drawing.Entities.Count, map))))];
    }

    /// <summary>The objects transformed by several maps; if there are too many, the bounding boxes of the first ones.</summary>
    public IReadOnlyList<Segment> Mapped(IReadOnlyList<Transform2D> maps)
    {
        var shown = _shown.Value.Length * maps.Count <= MaxSegments + _box.Value.Length ? _shown.Value : _box.Value;
        return [.. maps.Take(MaxSegments / Math.Max(1, _box.Value.Length)).SelectMany(map => shown.Select(segment => segment.Mapped(map)))];
    }

    private Segment[] Sample(Drawing drawing, IReadOnlyList<int> selected)
    {
        var parts = selected.Sum(index => (long)drawing.Entities[index].PartCount);
        var segments = selected.SelectMany(index => DrawingPick.Segments(drawing, index));
        if (parts <= MaxSegments) return [.. segments];
        var step = 1 + (parts / MaxSegments);
        return [.. _box.Value, .. segments.Where((_, place) => place % step == 0)];
    }

    private static Segment[] BoxOf(Drawing drawing, IReadOnlyList<int> selected)
    {
        var box = DrawingPick.BoundsOf(drawing, selected);
        if (box.IsEmpty) return [];
        Point2D[] corners = [new(box.MinX, box.MinY), new(box.MaxX, box.MinY), new(box.MaxX, box.MaxY), new(box.MinX, box.MaxY)];
        return [.. corners.Select((corner, i) => Segment.FromLine(corner, corners[(i + 1) % corners.Length]))];
    }
}
