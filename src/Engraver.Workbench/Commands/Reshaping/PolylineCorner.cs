using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Two parts of one polyline joined by a fillet: the first leads into it, the second continues from it; a part between them is removed.</summary>
/// <param name="Before">Index of the part that leads into it, from 0.</param>
/// <param name="After">Index of the part that continues from it; less than <paramref name="Before"/> at the seam.</param>
internal readonly record struct PolylineCorner(int Before, int After, Fillet Fillet)
{
    /// <summary>Neighbouring parts, two lines with one part between them, and the last and the first part of an open polyline can be joined, as in
    /// AutoCAD.</summary>
    public static bool AreJoinable(Drawing drawing, int entity, int first, int second)
    {
        var row = drawing.Entities[entity];
        return first != second && (Follows(drawing, row, first, second) || Follows(drawing, row, second, first));
    }

    /// <summary>The corner that a fillet makes of two parts, picked in any order.</summary>
    /// <returns>Null if the fillet is at other ends of the parts.</returns>
    public static PolylineCorner? From(Drawing drawing, int entity, int first, int second, Fillet fillet)
    {
        var corner = fillet switch
        {
            { First.EndsAtJoint: true, Second.EndsAtJoint: false } => new PolylineCorner(first, second, fillet),
            { First.EndsAtJoint: false, Second.EndsAtJoint: true } => new PolylineCorner(second, first, new Fillet(fillet.Second, fillet.First, fillet.Between?.Reversed())),
            _ => default(PolylineCorner?),
        };
        return corner is { } known && Follows(drawing, drawing.Entities[entity], known.Before, known.After) ? known : null;
    }

    /// <summary>The part after another one; null after the last one of an open polyline.</summary>
    public static int? Next(in DrawingEntity row, int part) => part + 1 < row.PartCount ? part + 1 : row.Closed && row.PartCount > 1 ? 0 : null;

    private static bool Follows(Drawing drawing, in DrawingEntity row, int before, int after)
    {
        if (Next(row, before) is not { } next) return after == 0;
        return next == after || (Next(row, next) == after && IsLine(drawing, row, before) && IsLine(drawing, row, after));
    }

    private static bool IsLine(Drawing drawing, in DrawingEntity row, int part) => drawing.Parts[row.FirstPart + part].Kind == SegmentKind.Line;
}

/// <summary>The filleted corners of one polyline.</summary>
/// <param name="count">Number of its parts.</param>
internal sealed class PolylineCorners(int count)
{
    private readonly Dictionary<int, PolylineCorner> _byBefore = [];
    private readonly Dictionary<int, PolylineCorner> _byAfter = [];
    private readonly HashSet<int> _removed = [];

    public int Count => _byBefore.Count;

    public void Add(PolylineCorner corner)
    {
        (_byBefore[corner.Before], _byAfter[corner.After]) = (corner, corner);
        for (var part = (corner.Before + 1) % count; part != corner.After; part = (part + 1) % count) _removed.Add(part);
    }

    /// <summary>True if both parts are long enough for this corner in addition to the existing ones.</summary>
    public bool HasRoom(int before, int after, Fillet fillet)
    {
        var begin = _byAfter.TryGetValue(before, out var ahead) ? ahead.Fillet.Second!.Value.Remaining.From : 0.0;
        var end = _byBefore.TryGetValue(after, out var behind) ? behind.Fillet.First!.Value.Remaining.To : 1.0;
        return fillet.First!.Value.Remaining.To > begin && fillet.Second!.Value.Remaining.From < end;
    }

    /// <summary>The parts of the polyline with these corners, keeping its heights.</summary>
    public List<DrawingPart> Applied(Drawing drawing, in DrawingEntity row, List<Segment> segments)
    {
        var parts = new List<DrawingPart>();
        for (var index = 0; index < segments.Count; index++)
        {
            if (_removed.Contains(index)) continue;
            var whole = drawing.Parts[row.FirstPart + index];
            var start = _byAfter.TryGetValue(index, out var behind) ? behind.Fillet.Second : null;
            var end = _byBefore.TryGetValue(index, out var ahead) ? ahead.Fillet.First : null;
            var piece = new PathRange(index, start?.Remaining.From ?? 0.0, end?.Remaining.To ?? 1.0, start?.Joint ?? segments[index].Start, end?.Joint ?? segments[index].End);
            parts.Add(start is null && end is null ? whole : ReshapedDrawing.PartOf(whole, piece, piece.Of(segments[index])));
            if (end is not null && ahead.Fillet.Between is { } between) parts.Add(ReshapedDrawing.PartOf(between, whole.Kind == SegmentKind.Line ? whole.F : whole.C));
        }

        return parts;
    }
}
