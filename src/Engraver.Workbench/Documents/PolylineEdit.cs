using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Workbench.Documents;

/// <summary>Explodes and joins polylines.</summary>
internal static class PolylineEdit
{
    /// <summary>Replaces polylines by their parts as separate entities.</summary>
    /// <returns>The rebuilt drawing, the indices of the parts, and the number of exploded polylines.</returns>
    public static (DrawingRebuild Rebuilt, IReadOnlyList<int> Parts, int Count) Explode(Drawing drawing, IEnumerable<int> indices)
    {
        var chosen = indices.Where(index => drawing.Entities[index].Type is CurveType.LwPolyline or CurveType.Polyline).ToHashSet();
        var rebuilt = new DrawingRebuild(drawing);
        var places = new List<int>();
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (!chosen.Contains(index))
            {
                rebuilt.Keep(index);
                continue;
            }

            foreach (var part in DrawingRebuild.PartsOf(drawing, index))
            {
                places.Add(rebuilt.Count);
                rebuilt.Add(drawing.Entities[index], TypeOf(part), part.Kind == SegmentKind.Circle, [part]);
            }
        }

        return (rebuilt, places, chosen.Count);
    }

    /// <summary>Joins lines, arcs and open polylines whose ends meet to polylines, at the index of their first entity and in its direction. At branches,
    /// entities that cannot be joined completely stay separate.</summary>
    /// <param name="tolerance">Drawing units.</param>
    public static (DrawingRebuild Rebuilt, IReadOnlyList<int> Joined, int Count) Join(Drawing drawing, IReadOnlyList<int> indices, double tolerance)
    {
        var runs = Runs(drawing, indices, tolerance);
        var gone = runs.SelectMany(run => run.Entities).ToHashSet();
        var first = runs.ToDictionary(run => run.Entities.Min());
        var rebuilt = new DrawingRebuild(drawing);
        var places = new List<int>();
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (first.TryGetValue(index, out var run))
            {
                places.Add(rebuilt.Count);
                rebuilt.Add(drawing.Entities[index], CurveType.LwPolyline, run.Closed, run.Parts);
            }
            else if (!gone.Contains(index))
            {
                rebuilt.Keep(index);
            }
        }

        return (rebuilt, places, gone.Count);
    }

    private static List<JoinedPolylineParts> Runs(Drawing drawing, IReadOnlyList<int> indices, double tolerance)
    {
        var parts = indices.Where(index => IsJoinable(drawing, index)).Order().SelectMany(index => DrawingRebuild.PartsOf(drawing, index)).ToList();
        var segments = parts.Select(part => part.InPlan()).ToArray();
        var runs = new List<JoinedPolylineParts>();
        foreach (var contour in ContourChainer.Chain(segments, tolerance).Contours)
        {
            var pieces = contour.Pieces.ToArray();
            var entities = pieces.Select(piece => parts[piece.Row].Entity).Distinct().ToList();
            var isWhole = entities.Sum(entity => drawing.Entities[entity].PartCount) == pieces.Length;
            if (entities.Count > 1 && isWhole) runs.Add(new JoinedPolylineParts(entities, [.. pieces.Select(piece => piece.Reversed ? parts[piece.Row].Reversed() : parts[piece.Row])], contour.Closed));
        }

        return runs;
    }

    private static bool IsJoinable(Drawing drawing, int index) =>
        drawing.Entities[index] is { Closed: false, Type: CurveType.Line or CurveType.Arc or CurveType.LwPolyline or CurveType.Polyline };

    public static CurveType TypeOf(in DrawingPart part) => part.Kind switch
    {
        SegmentKind.Line => CurveType.Line,
        SegmentKind.Circle => CurveType.Circle,
        SegmentKind.Ellipse => CurveType.Ellipse,
        SegmentKind.Spline => CurveType.Spline,
        _ => CurveType.Arc,
    };

    private sealed record JoinedPolylineParts(IReadOnlyList<int> Entities, IReadOnlyList<DrawingPart> Parts, bool Closed);
}
