using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>A polyline with filleted or chamfered corners.</summary>
/// <param name="Closed">It is closed; an open one becomes closed if its last and first part were joined.</param>
/// <param name="Rounded">Number of corners that were joined.</param>
/// <param name="Skipped">Number of unchanged corners, because a line is too short.</param>
internal sealed record RoundedPolyline(int Entity, IReadOnlyList<DrawingPart> Parts, bool Closed, int Rounded, int Skipped)
{
    /// <summary>Every corner between two lines; an arc between two converging lines is replaced by the new one, as in AutoCAD. A line that is rounded at both
    /// ends must be long enough for both.</summary>
    public static RoundedPolyline Of(Drawing drawing, int entity, FilletSettings shape)
    {
        var row = drawing.Entities[entity];
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        var (corners, left) = (new PolylineCorners(segments.Count), 0);
        for (var before = 0; before < segments.Count; before++)
        {
            if (After(row, segments, before, overArcs: !shape.IsChamfer) is not { } after) continue;
            var fillet = shape.Of(segments[before], segments[before].PointAt(0.5), segments[after], segments[after].PointAt(0.5));
            if (fillet is { First.EndsAtJoint: true, Second.EndsAtJoint: false } && corners.HasRoom(before, after, fillet)) corners.Add(new PolylineCorner(before, after, fillet));
            else left++;
        }

        return new RoundedPolyline(entity, corners.Applied(drawing, row, segments), row.Closed, corners.Count, left);
    }

    /// <summary>Rounds one corner.</summary>
    public static RoundedPolyline With(Drawing drawing, int entity, PolylineCorner corner)
    {
        var row = drawing.Entities[entity];
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        var corners = new PolylineCorners(segments.Count);
        corners.Add(corner);
        return new RoundedPolyline(entity, corners.Applied(drawing, row, segments), row.Closed || corner.After < corner.Before, 1, 0);
    }

    /// <summary>Commits one undo step.</summary>
    public void Commit(CommandContext context)
    {
        var rebuilt = new DrawingRebuild(context.Drawing);
        for (var index = 0; index < context.Drawing.Entities.Count; index++)
        {
            if (index == Entity) rebuilt.Change(index, context.Drawing.Entities[index].Type, Closed, Parts);
            else rebuilt.Keep(index);
        }

        DrawingChange.Commit(context, rebuilt, [Entity]);
    }

    /// <summary>The line after the corner at the end of a line; null if there is no corner.</summary>
    private static int? After(in DrawingEntity row, List<Segment> segments, int before, bool overArcs)
    {
        if (segments[before].Kind != SegmentKind.Line || PolylineCorner.Next(row, before) is not { } next || next == before) return null;
        if (segments[next].Kind == SegmentKind.Line) return IsStraight(segments[before], segments[next]) ? null : next;
        if (!overArcs || segments[next].Kind != SegmentKind.Arc || PolylineCorner.Next(row, next) is not { } beyond || beyond == before) return null;
        return segments[beyond].Kind == SegmentKind.Line && Meet(segments[before], segments[beyond]) ? beyond : null;
    }

    private static bool IsStraight(Segment before, Segment after) => Math.Abs(before.EndTangent.Cross(after.StartTangent)) < 1e-9;

    /// <summary>True if both lines, extended, intersect beyond the end of the first and before the start of the second.</summary>
    private static bool Meet(Segment before, Segment after)
    {
        var (way, ahead, beyond) = (after.Start - before.End, before.EndTangent, after.StartTangent);
        var turn = ahead.Cross(beyond);
        return Math.Abs(turn) > 1e-9 && way.Cross(beyond) / turn >= 0.0 && way.Cross(ahead) / turn <= 0.0;
    }
}
