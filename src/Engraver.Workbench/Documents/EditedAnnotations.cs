using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Documents;

/// <summary>What happens to the texts and points of a drawing when objects are edited. Selected texts are edited. Points cannot be selected, nor can texts without
/// letters: they move with an edit of everything else that is visible, and otherwise do not move.</summary>
internal sealed class EditedAnnotations
{
    private readonly Drawing _drawing;
    private readonly HashSet<PlacedText> _texts;
    private readonly Func<PlacedPoint, bool> _takes;
    private readonly int _points;

    private EditedAnnotations(Drawing drawing, IEnumerable<PlacedText> texts, Func<PlacedPoint, bool> takes)
    {
        (_drawing, _takes) = (drawing, takes);
        _texts = new HashSet<PlacedText>(texts, ReferenceEqualityComparer.Instance);
        _points = drawing.Points.Count(takes);
    }

    /// <summary>Number of points that do not move.</summary>
    public int UnmovedPoints => _drawing.Points.Count - _points;

    /// <summary>Selects the texts and points that move with an edit of these objects: the selected texts; the visible ones if all that is visible is edited; all
    /// if everything is edited.</summary>
    /// <param name="drawing">The drawing before the edit.</param>
    /// <param name="selected">Indices of objects.</param>
    /// <param name="takesLocked">Also those on locked layers: they are only copied, or the whole drawing is edited.</param>
    public static EditedAnnotations For(Drawing drawing, IReadOnlyList<int> selected, bool takesLocked)
    {
        if (drawing.Texts.Count + drawing.Points.Count == 0) return new EditedAnnotations(drawing, [], _ => false);
        var taken = selected.ToHashSet();
        var shown = ShownDrawing.Of(drawing);
        var chosen = drawing.Texts.Where((_, text) => taken.Contains(drawing.Entities.Count + text));
        var all = taken.Count == shown.Entities.Count;
        if (!all && !DrawingPick.Visible(shown).All(entity => taken.Contains(entity) || IsWithoutLetters(entity))) return new EditedAnnotations(drawing, chosen, _ => false);
        return new EditedAnnotations(drawing, [.. chosen, .. drawing.Texts.Where(text => IsFree(text.Layer) && (all || text.IsVisibleIn(drawing)))], point => IsFree(point.Layer) && (all || point.IsVisibleIn(drawing)));

        bool IsWithoutLetters(int entity) => entity >= drawing.Entities.Count && shown.Entities[entity].PartCount == 0;

        bool IsFree(int layer) => takesLocked || !drawing.Layers[layer].Locked;
    }

    /// <summary>The edited drawing with the selected texts and points moved.</summary>
    public Drawing Moved(Drawing edited, Transform2D map) => edited with
    {
        Texts = _texts.Count == 0 ? _drawing.Texts : [.. _drawing.Texts.Select(text => _texts.Contains(text) ? Placed(text, map) : text)],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points.Select(point => _takes(point) ? Placed(point, map) : point)],
    };

    /// <summary>The edited drawing with a copy of the selected texts and points for each map; copies of texts have no handle.</summary>
    public Drawing Copied(Drawing edited, IReadOnlyList<Transform2D> maps) => edited with
    {
        Texts = [.. _drawing.Texts, .. maps.SelectMany(map => _drawing.Texts.Where(_texts.Contains).Select(text => Placed(text, map) with { Handle = 0 }))],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points, .. maps.SelectMany(map => _drawing.Points.Where(_takes).Select(point => Placed(point, map)))],
    };

    /// <summary>The edited drawing without the selected texts and points.</summary>
    public Drawing Without(Drawing edited) => edited with
    {
        Texts = [.. _drawing.Texts.Where(text => !_texts.Contains(text))],
        Points = _points == 0 ? _drawing.Points : [.. _drawing.Points.Where(point => !_takes(point))],
    };

    /// <summary>Mirrored text is mirror-inverted, like the rest of a mirrored drawing.</summary>
    private static PlacedText Placed(PlacedText text, Transform2D map) => text with
    {
        Position = At(text.Position, map),
        End = text.End is { } end ? At(end, map) : null,
        Height = text.Height * map.Scale,
        FrameWidth = text.FrameWidth * map.Scale,
        Rotation = (map.Mirrored ? map.Turn - text.Rotation : map.Turn + text.Rotation).Positive(),
        Mirrored = text.Mirrored ^ map.Mirrored,
        Inserts = Placement.FromPlane(map).After(text.Inserts),
    };

    private static PlacedPoint Placed(PlacedPoint point, Transform2D map) => point with { Position = At(point.Position, map) };

    private static Vector3D At(Vector3D place, Transform2D map)
    {
        var moved = map.Apply(new Point2D(place.X, place.Y));
        return new Vector3D(moved.X, moved.Y, place.Z);
    }
}
