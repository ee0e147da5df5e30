using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>What STRETCH works on: objects, some by boxes in which their ends move, the others whole.</summary>
/// <param name="before">Objects that were selected before the command; they move whole.</param>
internal sealed class Stretch(IReadOnlyList<int> before)
{
    private readonly Stack<(IReadOnlyList<int> Entities, Bounds2D? Box)> _picked = new(before.Count > 0 ? [(before, null)] : []);

    /// <summary>Every object, each once.</summary>
    public IReadOnlyList<int> Entities => [.. _picked.SelectMany(pick => pick.Entities).Distinct().Order()];

    /// <param name="box">The box that crosses them; null: they move whole.</param>
    /// <returns>How many were found, as a selection says it.</returns>
    public string Add(IReadOnlyList<int> entities, Bounds2D? box)
    {
        var again = entities.Intersect(Entities).Count();
        _picked.Push((entities, box));
        return again > 0 ? Wording.Get("ObjectSelection.FoundDuplicate", entities.Count, again, Entities.Count) : Wording.Get("ObjectSelection.FoundTotal", entities.Count, Entities.Count);
    }

    public void Back() => _picked.TryPop(out _);

    /// <summary>Those that move whole.</summary>
    public IReadOnlyList<int> Whole(Drawing drawing) => [.. Entities.Where(entity => IsWhole(drawing, entity))];

    /// <summary>The drawing after everything was moved by a way.</summary>
    public StretchedDrawing Of(Drawing drawing, Vector2D by)
    {
        var (whole, parts, unchanged) = (new List<int>(), new List<(int Index, DrawingPart Part)>(), 0);
        foreach (var entity in Entities)
        {
            if (IsWhole(drawing, entity))
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

    /// <summary>Picked singly or by a window, or with all that defines it in a box: the ends, a circle's or an ellipse's middle.</summary>
    private bool IsWhole(Drawing drawing, int entity)
    {
        if (_picked.Any(pick => pick.Box is null && pick.Entities.Contains(entity))) return true;
        var segments = DrawingPick.Segments(drawing, entity).ToList();
        if (segments is [{ Kind: SegmentKind.Circle } circle]) return IsIn(entity, circle.Arc.Centre);
        if (segments is [{ IsFreeCurve: true } curve]) return curve.Bounds is var box && IsIn(entity, curve.IsClosed ? new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0) : curve.Start) && (curve.IsClosed || IsIn(entity, curve.End));
        return segments.Count > 0 && segments.TrueForAll(segment => IsIn(entity, segment.Start) && IsIn(entity, segment.End));
    }
}

/// <summary>A drawing after STRETCH.</summary>
/// <param name="Edited">Null when an object would shrink to a point, or go out of the range of a drawing.</param>
/// <param name="Unchanged">Objects of which nothing that can be moved lay in a box.</param>
/// <param name="Shown">What has moved: the ghost.</param>
internal sealed record StretchedDrawing(Drawing? Edited, int Unchanged, IReadOnlyList<Segment> Shown);

/// <summary>An object of which some ends or vertices move.</summary>
internal static class StretchedParts
{
    /// <param name="moves">Whether an end at this place moves.</param>
    /// <returns>The parts that change, by their index; none when no end moves; null when one would shrink to a point.</returns>
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

    /// <summary>An arc by itself keeps its height over the chord, one of a polyline its bulge, as in AutoCAD.</summary>
    private static DrawingPart Moved(in DrawingPart part, in Segment segment, Point2D start, Point2D end, bool isSingle)
    {
        if (part.Kind == SegmentKind.Line) return DrawingPart.Line(part.Entity, start.X, start.Y, part.C, end.X, end.Y, part.F);
        var bulge = Math.Tan(segment.Arc.Sweep.Radians / 4.0);
        if (isSingle) bulge *= segment.Start.DistanceTo(segment.End) / start.DistanceTo(end);
        return DrawingPart.Arc(part.Entity, ArcSegment.FromBulge(start, end, bulge), part.C);
    }

    private static bool Fits(Point2D place) => Math.Abs(place.X) <= Drawing.LargestCoordinate && Math.Abs(place.Y) <= Drawing.LargestCoordinate;
}
