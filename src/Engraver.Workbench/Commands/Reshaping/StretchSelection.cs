using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>The selection of STRETCH: objects whose ends move if they are in a box, and objects that move completely.</summary>
/// <param name="before">Objects selected before the command; they move completely.</param>
internal sealed class StretchSelection(IReadOnlyList<int> before)
{
    private readonly Stack<(IReadOnlyList<int> Entities, Bounds2D? Box)> _picked = new(before.Count > 0 ? [(before, null)] : []);

    /// <summary>Every object, each once.</summary>
    public IReadOnlyList<int> Entities => [.. _picked.SelectMany(pick => pick.Entities).Distinct().Order()];

    /// <param name="box">The crossing box; null: they move completely.</param>
    /// <returns>The selection message with the number found.</returns>
    public string Add(IReadOnlyList<int> entities, Bounds2D? box)
    {
        var again = entities.Intersect(Entities).Count();
        _picked.Push((entities, box));
        return again > 0 ? Wording.Get("ObjectSelection.FoundDuplicate", entities.Count, again, Entities.Count) : Wording.Get("ObjectSelection.FoundTotal", entities.Count, Entities.Count);
    }

    public void Undo() => _picked.TryPop(out _);

    /// <summary>The objects that move completely.</summary>
    public IReadOnlyList<int> FullySelected(Drawing drawing) => [.. Entities.Where(entity => IsFullySelected(drawing, entity))];

    /// <summary>The drawing after the displacement.</summary>
    public StretchedDrawing Of(Drawing drawing, Vector2D by)
    {
        var (whole, parts, unchanged) = (new List<int>(), new List<(int Index, DrawingPart Part)>(), 0);
        foreach (var entity in Entities)
        {
            if (IsFullySelected(drawing, entity))
            {
                whole.Add(entity);
                continue;
            }

            var moved = StretchedParts.Of(drawing, entity, place => IsIn(entity, place), by);
            if (moved is null) return new StretchedDrawing(null, 0, []);
            if (moved.Count == 0) unchanged++;
            parts.AddRange(moved);
        }

        if (!DrawingEdit.TryTransform(drawing, whole, Transform2D.Move(by), out var edited)) return new StretchedDrawing(null, 0, []);
        return new StretchedDrawing(edited with { Parts = edited.Parts.With(parts, []) }, unchanged, [.. whole.SelectMany(entity => DrawingPick.Segments(edited, entity)), .. parts.Select(part => part.Part.InPlan())]);
    }

    private bool IsIn(int entity, Point2D place) => _picked.Any(pick => pick.Box is { } box && box.Contains(place) && pick.Entities.Contains(entity));

    /// <summary>True if picked individually or by a window, or if all its defining points are in a box: the ends, or the centre of a circle or an
    /// ellipse.</summary>
    private bool IsFullySelected(Drawing drawing, int entity)
    {
        if (_picked.Any(pick => pick.Box is null && pick.Entities.Contains(entity))) return true;
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        if (segments is [{ Kind: SegmentKind.Circle } circle]) return IsIn(entity, circle.Arc.Centre);
        if (segments is [{ IsFreeCurve: true } curve]) return curve.Bounds is var box && IsIn(entity, curve.IsClosed ? new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0) : curve.Start) && (curve.IsClosed || IsIn(entity, curve.End));
        return segments.Count > 0 && segments.TrueForAll(segment => IsIn(entity, segment.Start) && IsIn(entity, segment.End));
    }
}

/// <summary>A drawing after STRETCH.</summary>
/// <param name="Edited">Null if an object would shrink to a point or exceed the range of a drawing.</param>
/// <param name="Unchanged">Number of objects without a movable point in a box.</param>
/// <param name="Preview">The moved segments, for the preview.</param>
internal sealed record StretchedDrawing(Drawing? Edited, int Unchanged, IReadOnlyList<Segment> Preview);

/// <summary>Objects of which only some ends or vertices move.</summary>
internal static class StretchedParts
{
    /// <param name="moves">Whether an end at this point moves.</param>
    /// <returns>The parts that change, by their index; empty if no end moves; null if one would shrink to a point.</returns>
    public static IReadOnlyList<(int Index, DrawingPart Part)>? Of(Drawing drawing, int entity, Func<Point2D, bool> moves, Vector2D by)
    {
        var row = drawing.Entities[entity];
        var changed = new List<(int, DrawingPart)>();
        for (var index = row.FirstPart; index < row.FirstPart + row.PartCount; index++)
        {
            var part = drawing.Parts[index];
            if (part.IsFreeCurve || part.Kind == SegmentKind.Circle) continue;
            var segment = part.InPlan();
            var (start, end) = (moves(segment.Start) ? segment.Start + by : segment.Start, moves(segment.End) ? segment.End + by : segment.End);
            if (start == segment.Start && end == segment.End) continue;
            if (start == end || !Fits(start) || !Fits(end)) return null;
            changed.Add((index, Moved(part, segment, start, end, row.PartCount == 1)));
        }

        return changed;
    }

    /// <summary>A separate arc keeps its height above the chord, an arc of a polyline its bulge, as in AutoCAD.</summary>
    private static DrawingPart Moved(in DrawingPart part, in Segment segment, Point2D start, Point2D end, bool isSingle)
    {
        if (part.Kind == SegmentKind.Line) return DrawingPart.Line(part.Entity, start.X, start.Y, part.C, end.X, end.Y, part.F);
        var bulge = Math.Tan(segment.Arc.Sweep.Radians / 4.0);
        if (isSingle) bulge *= segment.Start.DistanceTo(segment.End) / start.DistanceTo(end);
        return DrawingPart.Arc(part.Entity, ArcSegment.FromBulge(start, end, bulge), part.C);
    }

    private static bool Fits(Point2D place) => Drawing.Holds(place.X) && Drawing.Holds(place.Y);
}
