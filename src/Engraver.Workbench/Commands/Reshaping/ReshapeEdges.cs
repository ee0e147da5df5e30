using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>The edges of TRIM and EXTEND. They stay the same objects while the drawing changes under them.</summary>
/// <param name="selected">Indices; null: every visible object.</param>
internal sealed class ReshapeEdges(IReadOnlyList<int>? selected)
{
    /// <summary>Whether edges cut beyond their ends is remembered under this name: Extend or No (AutoCAD's EDGEMODE).</summary>
    public const string Mode = "EDGEMODE";

    private readonly Stack<IReadOnlyList<int>?> _before = new();
    private IReadOnlyList<int>? _selected = selected;

    /// <summary>Lines and arcs cut, and are reached, beyond their ends too.</summary>
    public bool AreLengthened { get; set; }

    /// <summary>After an edit: where the edges stand now.</summary>
    public void Follow(Func<IReadOnlyList<int>, IReadOnlyList<int>> places)
    {
        _before.Push(_selected);
        _selected = _selected is { } all ? places(all) : null;
    }

    /// <summary>The edit was taken back.</summary>
    public void Back() => _selected = _before.TryPop(out var before) ? before : _selected;

    /// <summary>What becomes of an object that is picked at a place.</summary>
    /// <returns>Null when nothing does.</returns>
    public ReshapedPath? Reshape(Drawing drawing, int entity, Point2D at, bool extends)
    {
        if (ReshapedDrawing.PathOf(drawing, entity) is not { } path) return null;
        return extends ? Extended(drawing, entity, path, at) : Trimmed(drawing, entity, path, at);
    }

    /// <summary>The sentence for an object of which nothing becomes anything.</summary>
    public static string WhyNot(Drawing drawing, int entity, bool extends)
    {
        if (!extends) return Wording.Get("Trim.NoCrossing");
        if (drawing.Entities[entity].Closed) return Wording.Get("Extend.Closed");
        return Wording.Get(drawing.Parts[drawing.Entities[entity].FirstPart].IsFreeCurve ? "Extend.FreeCurve" : "Extend.NoEdge");
    }

    private ReshapedPath? Trimmed(Drawing drawing, int entity, EntityPath path, Point2D at)
    {
        var reach = path.Parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(part.Bounds));
        var crossings = path.Crossings(Edges(drawing, entity, AreLengthened ? null : reach), AreLengthened);
        return PathCut.Trim(path, crossings, path.Nearest(at)) is { } cut ? new ReshapedPath(cut.Kept, [.. cut.Removed.Select(piece => piece.Of(path.Parts[piece.Part]))]) : null;
    }

    private ReshapedPath? Extended(Drawing drawing, int entity, EntityPath path, Point2D at)
    {
        if (PathExtension.Find(path, Edges(drawing, entity, null), at, AreLengthened) is not { } found) return null;
        PathPiece[] pieces = [.. path.Parts.Select((part, index) => index == found.Grown.Part ? found.Grown : PathPiece.Whole(index, part))];
        return new ReshapedPath([pieces], [found.Added.Of(path.Parts[found.Added.Part])]);
    }

    /// <param name="reach">Only what comes near this box; null for all.</param>
    private IEnumerable<Segment> Edges(Drawing drawing, int besides, Bounds2D? reach)
    {
        foreach (var entity in _selected ?? DrawingPick.Visible(drawing))
        {
            if (entity == besides) continue;
            foreach (var segment in DrawingPick.Segments(drawing, entity))
            {
                if (reach is not { } box || Near(segment.Bounds, box)) yield return segment;
            }
        }
    }

    private static bool Near(Bounds2D edge, Bounds2D box)
    {
        var slack = 1e-6 * (box.Width + box.Height);
        return edge.MinX <= box.MaxX + slack && edge.MaxX >= box.MinX - slack && edge.MinY <= box.MaxY + slack && edge.MaxY >= box.MinY - slack;
    }
}

/// <summary>Another shape of an object.</summary>
/// <param name="Kept">Each becomes an object.</param>
/// <param name="Shown">What goes, or what is added: the ghost.</param>
internal sealed record ReshapedPath(IReadOnlyList<IReadOnlyList<PathPiece>> Kept, IReadOnlyList<Segment> Shown);
