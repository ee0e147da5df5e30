using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>A polyline with arcs or bevels at its corners.</summary>
/// <param name="Made">Number of corners that were joined.</param>
/// <param name="Left">Number of corners between lines that stay, because a line is too short.</param>
internal sealed record RoundedPolyline(int Entity, IReadOnlyList<DrawingPart> Parts, int Made, int Left)
{
    /// <summary>Every corner between two lines. A line that is rounded at both ends must be long enough for both.</summary>
    public static RoundedPolyline Of(Drawing drawing, int entity, CornerShape shape)
    {
        var row = drawing.Entities[entity];
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        var (corners, left) = (new Dictionary<int, Fillet>(), 0);
        for (var index = 0; index < (row.Closed ? segments.Count : segments.Count - 1); index++)
        {
            var (before, after) = (segments[index], segments[(index + 1) % segments.Count]);
            if (before.Kind != SegmentKind.Line || after.Kind != SegmentKind.Line || IsStraight(before, after)) continue;
            var fillet = shape.Of(before, before.PointAt(0.5), after, after.PointAt(0.5));
            if (fillet is { First.EndsThere: true, Second.EndsThere: false } && Room(corners, index, segments.Count, fillet)) corners[index] = fillet;
            else left++;
        }

        return new RoundedPolyline(entity, PartsWith(drawing, row, segments, corners), corners.Count, left);
    }

    /// <summary>One corner between two neighbouring parts.</summary>
    /// <param name="first">The part that was picked first; the order of the two does not matter.</param>
    public static RoundedPolyline WithCorner(Drawing drawing, int entity, int first, int second, Fillet fillet)
    {
        var row = drawing.Entities[entity];
        var index = Next(row, first) == second && fillet.First is { EndsThere: true } ? first : second;
        var directed = index == first ? fillet : new Fillet(fillet.Second, fillet.First, fillet.Between?.Reversed());
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        return new RoundedPolyline(entity, PartsWith(drawing, row, segments, new Dictionary<int, Fillet> { [index] = directed }), 1, 0);
    }

    /// <summary>True when one part begins where the other ends.</summary>
    public static bool AreNeighbours(in DrawingEntity row, int first, int second) => Next(row, first) == second || Next(row, second) == first;

    /// <summary>The fillet lies at the vertex between the two.</summary>
    public static bool Fits(Fillet fillet, int first, int second, in DrawingEntity row) =>
        (Next(row, first) == second && fillet is { First.EndsThere: true, Second.EndsThere: false }) || (Next(row, second) == first && fillet is { First.EndsThere: false, Second.EndsThere: true });

    /// <summary>One document step.</summary>
    public void Take(CommandContext context)
    {
        var rebuilt = new DrawingRebuild(context.Drawing);
        for (var index = 0; index < context.Drawing.Entities.Count; index++)
        {
            var row = context.Drawing.Entities[index];
            if (index == Entity) rebuilt.Change(index, row.Type, row.Closed, Parts);
            else rebuilt.Keep(index);
        }

        DrawingChange.Take(context, rebuilt, [Entity]);
    }

    private static int? Next(in DrawingEntity row, int part) => part + 1 < row.PartCount ? part + 1 : row.Closed && row.PartCount > 1 ? 0 : null;

    private static bool IsStraight(Segment before, Segment after) => Math.Abs(before.EndTangent.Cross(after.StartTangent)) < 1e-9;

    private static bool Room(Dictionary<int, Fillet> corners, int index, int count, Fillet fillet)
    {
        var begin = corners.GetValueOrDefault((index + count - 1) % count)?.Second?.Kept.From ?? 0.0;
        var end = corners.GetValueOrDefault((index + 1) % count)?.First?.Kept.To ?? 1.0;
        return fillet.First!.Value.Kept.To > begin && fillet.Second!.Value.Kept.From < end;
    }

    private static List<DrawingPart> PartsWith(Drawing drawing, in DrawingEntity row, List<Segment> segments, Dictionary<int, Fillet> corners)
    {
        var parts = new List<DrawingPart>();
        for (var index = 0; index < segments.Count; index++)
        {
            var whole = drawing.Parts[row.FirstPart + index];
            var after = corners.GetValueOrDefault((index + segments.Count - 1) % segments.Count)?.Second;
            var before = corners.GetValueOrDefault(index)?.First;
            var piece = new PathPiece(index, after?.Kept.From ?? 0.0, before?.Kept.To ?? 1.0, after?.Joint ?? segments[index].Start, before?.Joint ?? segments[index].End);
            parts.Add(after is null && before is null ? whole : ReshapedDrawing.PartOf(whole, piece, piece.Of(segments[index])));
            if (corners.GetValueOrDefault(index)?.Between is { } between) parts.Add(ReshapedDrawing.PartOf(between, whole.Kind == SegmentKind.Line ? whole.F : whole.C));
        }

        return parts;
    }
}
