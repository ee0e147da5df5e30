using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>The outline of a toolpath as a separate toolpath: a machine follows it with the tool off before a job to show that the workpiece is in the correct
/// position.</summary>
public static class FrameOutline
{
    /// <summary>An arc is replaced by chords of at most this angle; its hull encloses them by the tangents.</summary>
    private const double LargestStepDegrees = 5.0;

    /// <summary>The smallest rectangle along the axes, counter-clockwise from its lower left corner.</summary>
    /// <returns>One closed stroke; for a single line along an axis, the path there and back; empty when nothing is cut.</returns>
    public static Toolpath Rectangle(Toolpath cut)
    {
        ArgumentNullException.ThrowIfNull(cut);
        var box = BoundsOf(cut);
        return box.IsEmpty ? cut with { Strokes = [] } : Round(cut, [new(box.MinX, box.MinY), new(box.MaxX, box.MinY), new(box.MaxX, box.MaxY), new(box.MinX, box.MaxY)]);
    }

    /// <summary>The convex hull, counter-clockwise. All cuts are inside it; around an arc it is wider by at most 0.1 % of the radius.</summary>
    /// <returns>One closed stroke; empty when nothing is cut.</returns>
    public static Toolpath Hull(Toolpath cut)
    {
        ArgumentNullException.ThrowIfNull(cut);
        var hull = ConvexHull([.. Moves(cut).SelectMany(PlacesOf).Distinct().OrderBy(place => place.X).ThenBy(place => place.Y)]);
        return hull.Count == 0 ? cut with { Strokes = [] } : Round(cut, hull);
    }

    /// <summary>The box of all cuts, millimetres; empty when nothing is cut.</summary>
    public static Bounds2D BoundsOf(Toolpath cut)
    {
        ArgumentNullException.ThrowIfNull(cut);
        return Moves(cut).Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
    }

    private static IEnumerable<Segment> Moves(Toolpath cut) => cut.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment);

    /// <summary>Points whose hull contains the segment: for an arc, the intersections of the tangents at neighbouring points.</summary>
    private static IEnumerable<Point2D> PlacesOf(Segment segment)
    {
        yield return segment.Start;
        yield return segment.End;
        if (segment.Kind == SegmentKind.Line) yield break;
        var arc = segment.Arc;
        var steps = (int)Math.Ceiling(Math.Abs(arc.Sweep.Degrees) / LargestStepDegrees);
        var reach = arc.Radius / Math.Cos(Math.Abs(arc.Sweep.Radians) / steps / 2.0);
        for (var i = 0; i < steps; i++) yield return arc.Centre + Vector2D.FromPolar(reach, arc.Start + (arc.Sweep * ((i + 0.5) / steps)));
    }

    /// <summary>Andrew's monotone chain.</summary>
    /// <param name="places">Points sorted by X, then by Y, without duplicates.</param>
    private static List<Point2D> ConvexHull(IReadOnlyList<Point2D> places)
    {
        if (places.Count < 3) return [.. places];
        var lower = Chain(places);
        var upper = Chain([.. places.Reverse()]);
        return [.. lower.Take(lower.Count - 1), .. upper.Take(upper.Count - 1)];
    }

    private static List<Point2D> Chain(IReadOnlyList<Point2D> places)
    {
        var chain = new List<Point2D>();
        foreach (var place in places)
        {
            while (chain.Count > 1 && Turn(chain[^2], chain[^1], place) <= 0.0) chain.RemoveAt(chain.Count - 1);
            chain.Add(place);
        }

        return chain;
    }

    /// <summary>Above 0 when the path turns to the left at <paramref name="middle"/>.</summary>
    private static double Turn(Point2D from, Point2D middle, Point2D to) => ((middle.X - from.X) * (to.Y - from.Y)) - ((middle.Y - from.Y) * (to.X - from.X));

    private static Toolpath Round(Toolpath cut, List<Point2D> corners)
    {
        var entity = cut.Strokes[0].Moves[0].EntityIndex;
        List<StrokeMove> moves = [];
        for (var i = 0; i < corners.Count; i++)
        {
            var (from, to) = (corners[i], corners[(i + 1) % corners.Count]);
            if (from != to) moves.Add(new StrokeMove(Segment.FromLine(from, to), entity));
        }

        return cut with { Strokes = moves.Count == 0 ? [] : [new ToolpathStroke(0, Closed: true, moves)] };
    }
}
