using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>The edges of TRIM and EXTEND. They remain the same objects while the drawing changes.</summary>
/// <param name="selected">Indices; null: every visible object.</param>
internal sealed class ReshapeEdges(IReadOnlyList<int>? selected)
{
    /// <summary>Name of the remembered edge mode: Extend or No (AutoCAD's EDGEMODE).</summary>
    public const string Mode = "EDGEMODE";

    private readonly Stack<IReadOnlyList<int>?> _before = new();
    private IReadOnlyList<int>? _selected = selected;

    /// <summary>True if lines and arcs act as edges beyond their ends too.</summary>
    public bool AreLengthened { get; set; }

    /// <summary>Updates the indices of the edges after an edit.</summary>
    public void Remap(Func<IReadOnlyList<int>, IReadOnlyList<int>> places)
    {
        _before.Push(_selected);
        _selected = _selected is { } all ? places(all) : null;
    }

    /// <summary>Reverts the last update of the indices.</summary>
    public void Undo() => _selected = _before.TryPop(out var before) ? before : _selected;

    /// <summary>The new shape of an object picked at a point.</summary>
    /// <returns>Null if it does not change.</returns>
    public ReshapedPath? Reshape(Drawing drawing, int entity, Point2D at, bool extends)
    {
        if (ReshapedDrawing.PathOf(drawing, entity) is not { } path) return null;
        return extends ? Extended(drawing, entity, path, at) : Trimmed(drawing, entity, path, at);
    }

    /// <summary>Why an object cannot be trimmed or extended.</summary>
    public static string RefusalOf(Drawing drawing, int entity, bool extends)
    {
        if (!extends) return Wording.Get("Trim.NoCrossing");
        if (drawing.Entities[entity].Closed) return Wording.Get("Extend.Closed");
        return Wording.Get(drawing.Parts[drawing.Entities[entity].FirstPart].IsFreeCurve ? "Extend.FreeCurve" : "Extend.NoEdge");
    }

    private ReshapedPath? Trimmed(Drawing drawing, int entity, EntityPath path, Point2D at)
    {
        var reach = path.Parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(part.Bounds));
        var crossings = path.Crossings(Edges(drawing, entity, AreLengthened ? null : reach), AreLengthened);
        return PathCut.Trim(path, crossings, path.Nearest(at)) is { } cut ? new ReshapedPath(cut.Remaining, [.. cut.Removed.Select(piece => piece.Of(path.Parts[piece.Part]))]) : null;
    }

    private ReshapedPath? Extended(Drawing drawing, int entity, EntityPath path, Point2D at)
    {
        if (PathExtension.Find(path, Edges(drawing, entity, null), at, AreLengthened) is not { } found) return null;
        PathRange[] pieces = [.. path.Parts.Select((part, index) => index == found.Grown.Part ? found.Grown : PathRange.Whole(index, part))];
        return new ReshapedPath([pieces], [found.Added.Of(path.Parts[found.Added.Part])]);
    }

    /// <param name="reach">Only edges near this box; null for all.</param>
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

/// <summary>New shape of an object.</summary>
/// <param name="Kept">Each becomes an object.</param>
/// <param name="Preview">The removed or added segments, for the preview.</param>
internal sealed record ReshapedPath(IReadOnlyList<IReadOnlyList<PathRange>> Kept, IReadOnlyList<Segment> Preview);
