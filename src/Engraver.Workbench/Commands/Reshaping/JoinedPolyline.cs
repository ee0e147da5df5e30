using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>An open polyline joined with another object by a fillet, as in AutoCAD: the parts beyond the fillet are removed.</summary>
internal sealed class JoinedPolyline
{
    private readonly Drawing _drawing;
    private readonly (CornerSide Side, FilletSide? Kept) _keeper;
    private readonly (CornerSide Side, FilletSide? Kept) _other;
    private readonly Segment? _between;

    private JoinedPolyline(Drawing drawing, (CornerSide Side, FilletSide? Kept) keeper, (CornerSide Side, FilletSide? Kept) other, Segment? between) =>
        (_drawing, _keeper, _other, _between) = (drawing, keeper, other, between);

    /// <summary>Joins to the first one that is an open polyline; null if neither is.</summary>
    public static JoinedPolyline? Of(Drawing drawing, CornerSide first, CornerSide second, Fillet fillet)
    {
        if (IsOpenPolyline(drawing, first.Entity)) return new JoinedPolyline(drawing, (first, fillet.First), (second, fillet.Second), fillet.Between);
        return IsOpenPolyline(drawing, second.Entity) ? new JoinedPolyline(drawing, (second, fillet.Second), (first, fillet.First), fillet.Between?.Reversed()) : null;
    }

    /// <summary>A closed polyline is not trimmed, like a circle.</summary>
    public static bool IsUnbroken(Drawing drawing, int entity) => drawing.Entities[entity] is { Type: CurveType.LwPolyline or CurveType.Polyline, Closed: true };

    /// <summary>Commits one undo step. The polyline keeps its direction, handle and layer.</summary>
    public void Commit(CommandContext context)
    {
        var rebuilt = new DrawingRebuild(_drawing);
        var takesIn = _other.Kept is not null && !IsUnbroken(_drawing, _other.Side.Entity);
        var parts = Joined(rebuilt, takesIn);
        for (var index = 0; index < _drawing.Entities.Count; index++)
        {
            if (index == _keeper.Side.Entity) rebuilt.Change(index, _drawing.Entities[index].Type, closed: false, parts);
            else if (index != _other.Side.Entity || !takesIn) rebuilt.Keep(index);
        }

        DrawingChange.Commit(context, rebuilt, rebuilt.NewIndices([_keeper.Side.Entity]));
    }

    private static bool IsOpenPolyline(Drawing drawing, int entity) => drawing.Entities[entity] is { Type: CurveType.LwPolyline or CurveType.Polyline, Closed: false };

    private List<DrawingPart> Joined(DrawingRebuild rebuilt, bool takesIn)
    {
        var path = Into(rebuilt, _keeper);
        if (_between is { } between) path.Add(ReshapedDrawing.PartOf(between, HeightAtEnd(path[^1])));
        if (takesIn) path.AddRange(Turned(rebuilt, Into(rebuilt, _other)));
        return _keeper.Kept!.Value.EndsAtJoint ? path : Turned(rebuilt, path);
    }

    /// <summary>The remaining part of an object, directed into the fillet.</summary>
    private List<DrawingPart> Into(DrawingRebuild rebuilt, (CornerSide Side, FilletSide? Kept) one)
    {
        var parts = DrawingRebuild.PartsOf(_drawing, one.Side.Entity);
        var (kept, part) = (one.Kept!.Value, one.Side.Part);
        parts[part] = ReshapedDrawing.PartOf(parts[part], kept.Remaining, kept.Remaining.Of(_drawing.SegmentOf(parts[part])));
        return kept.EndsAtJoint ? parts[..(part + 1)] : Turned(rebuilt, parts[part..]);
    }

    private static List<DrawingPart> Turned(DrawingRebuild rebuilt, List<DrawingPart> parts) => [.. parts.AsEnumerable().Reverse().Select(part => part.IsFreeCurve ? rebuilt.PartOf(rebuilt.CurveOf(part).Reversed()) : part.Reversed())];

    private static double HeightAtEnd(in DrawingPart part) => part.Kind == SegmentKind.Line ? part.F : part.IsFreeCurve ? 0.0 : part.C;
}
