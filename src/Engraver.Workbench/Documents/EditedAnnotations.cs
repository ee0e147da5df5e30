using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Documents;

/// <summary>What happens to the texts and points of a drawing when objects are edited. Selected texts are edited. Points cannot be selected, nor can texts
/// without letters and inserts without curves: they move with an edit of everything else that is visible, and otherwise do not move.</summary>
internal sealed class EditedAnnotations
{
    private readonly Drawing _drawing;
    private readonly HashSet<PlacedText> _texts;
    private readonly Func<PlacedPoint, bool> _takes;
    private readonly int _points;
    private readonly bool _takesInserts;

    private EditedAnnotations(Drawing drawing, IEnumerable<PlacedText> texts, Func<PlacedPoint, bool> takes, bool takesInserts)
    {
        (_drawing, _takes, _takesInserts) = (drawing, takes, takesInserts);
        _texts = new HashSet<PlacedText>(texts, ReferenceEqualityComparer.Instance);
        _points = drawing.Points.Count(takes);
    }

    /// <summary>Mirrored texts stay readable (MIRRTEXT 0).</summary>
    public bool KeepsTextDirection { get; init; }

    /// <summary>Number of points that do not move.</summary>
    public int UnmovedPoints => _drawing.Points.Count - _points;

    /// <summary>Selects the texts and points that move with an edit of these objects: the selected texts; the visible ones if all that is visible is edited;
    /// all if everything is edited.</summary>
    /// <param name="drawing">The drawing before the edit.</param>
    /// <param name="selected">Indices of objects.</param>
    /// <param name="takesLocked">Also those on locked layers: they are only copied, or the whole drawing is edited.</param>
    /// <param name="keepsTextDirection">Mirrored texts stay readable.</param>
    public static EditedAnnotations For(Drawing drawing, IReadOnlyList<int> selected, bool takesLocked, bool keepsTextDirection)
    {
        if (drawing.Texts.Count + drawing.Points.Count == 0 && !DrawingEdit.HasFreeInserts(drawing)) return new EditedAnnotations(drawing, [], _ => false, takesInserts: false);
        var taken = selected.ToHashSet();
        var chosen = drawing.Texts.Where((_, text) => taken.Contains(drawing.Entities.Count + text));
        var all = taken.Count == drawing.Entities.Count + drawing.Texts.Count;
        if (!all && !TakesAllVisible(drawing, taken)) return new EditedAnnotations(drawing, chosen, _ => false, takesInserts: false) { KeepsTextDirection = keepsTextDirection };
        return new EditedAnnotations(drawing, [.. chosen, .. drawing.Texts.Where(text => IsFree(text.Layer) && (all || text.IsVisibleIn(drawing)))], point => IsFree(point.Layer) && (all || point.IsVisibleIn(drawing)), takesInserts: true) { KeepsTextDirection = keepsTextDirection };

        bool IsFree(int layer) => takesLocked || !drawing.Layers[layer].Locked;
    }

    private static bool TakesAllVisible(Drawing drawing, HashSet<int> taken)
    {
        var shown = ShownDrawing.Of(drawing);
        return DrawingPick.Visible(shown).All(entity => taken.Contains(entity) || (entity >= drawing.Entities.Count && shown.Entities[entity].PartCount == 0));
    }

    /// <summary>The edited drawing with the selected texts and points moved.</summary>
    public Drawing Moved(Drawing edited, Transform2D map) => (_takesInserts ? DrawingEdit.MoveFreeInserts(edited, map) : edited) with
    {
        Texts = _texts.Count == 0 ? _drawing.Texts : [.. _drawing.Texts.Select((text, index) => _texts.Contains(text) ? Placed(index, map) : text)],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points.Select(point => _takes(point) ? point.Transformed(map) : point)],
    };

    /// <summary>The edited drawing with a copy of the selected texts and points for each map; copies of texts have new handles.</summary>
    public Drawing Copied(Drawing edited, IReadOnlyList<Transform2D> maps) => (_takesInserts ? DrawingEdit.CopyFreeInserts(edited, _drawing, maps) : edited) with
    {
        Texts = _texts.Count == 0 ? _drawing.Texts : [.. _drawing.Texts, .. WithHandles(maps.SelectMany(map => Enumerable.Range(0, _drawing.Texts.Count).Where(index => _texts.Contains(_drawing.Texts[index])).Select(index => Placed(index, map))), edited.HighestHandle())],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points, .. maps.SelectMany(map => _drawing.Points.Where(_takes).Select(point => point.Transformed(map)))],
    };

    /// <summary>The edited drawing without the selected texts and points.</summary>
    public Drawing Without(Drawing edited) => (_takesInserts ? DrawingEdit.EraseFreeInserts(edited) : edited) with
    {
        Texts = [.. _drawing.Texts.Where(text => !_texts.Contains(text))],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points.Where(point => !_takes(point))],
    };

    private static IEnumerable<PlacedText> WithHandles(IEnumerable<PlacedText> texts, ulong handle)
    {
        foreach (var text in texts) yield return text with { Handle = ++handle };
    }

    private PlacedText Placed(int text, Transform2D map) => _drawing.Texts[text].Transformed(KeepsTextDirection ? Readable(_drawing, text, map) : map);

    /// <summary>A mirrored text stays readable: its letters are moved into the mirrored box. Other maps are unchanged.</summary>
    public static Transform2D Readable(Drawing drawing, int text, Transform2D map)
    {
        if (!map.Mirrored) return map;
        var (placed, box) = (drawing.Texts[text], DrawingPick.BoundsOf(ShownDrawing.Of(drawing), [drawing.Entities.Count + text]));
        var centre = box.IsEmpty ? new Point2D(placed.Position.X, placed.Position.Y) : new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0);
        var turn = map.Turn - (placed.Rotation * 2.0); // mirrored across its line as well
        if (turn.Cos() < 0.0) turn += Angle.FromDegrees(180.0);
        var turned = Transform2D.Rotate(centre, turn.Positive());
        return turned with { Shift = turned.Shift + (map.Apply(centre) - centre) };
    }
}
