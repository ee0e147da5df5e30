using Engraver.Core.Geometry;

namespace Engraver.Core.Unions;

/// <summary>Unites closed contours by the non-zero winding rule: a point is covered when the contours run around it more often in one direction than in the
/// other. Outlines of letters are defined so.</summary>
/// <remarks>
/// Contours whose boxes overlap form a group. A group is cut at all its crossings (<see cref="Offsets.Graphs.PieceGraph"/>), edges that coincide are counted
/// together, the winding number on both sides of each run decides whether it is part of an outline (<see cref="UnionBoundary"/>), and edges are joined by the
/// numbers of their nodes, so that every outline is closed.
/// </remarks>
public static class ContourUnion
{
    /// <param name="contours">Closed contours of lines, arcs and circles in any direction; they may cross themselves and each other.</param>
    /// <param name="tolerance">Distance that counts as zero, far below the required accuracy: edges and points as near as this coincide, and what is narrower
    /// disappears. Where it is less than the rounding of the coordinates, the rounding is used.</param>
    /// <returns>A contour that no other touches and that does not cross itself is returned as given, with the same segments, or reversed if the area would be
    /// on its right.</returns>
    public static UnionResult Unite(IReadOnlyList<IReadOnlyList<Segment>> contours, double tolerance)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(tolerance);
        var (united, unresolved, closed) = (new List<IReadOnlyList<Segment>>(contours.Count), new List<Point2D>(), new List<IReadOnlyList<Segment>>(contours.Count));
        foreach (var contour in contours.Where(contour => contour.Count > 0))
        {
            if (OpenPlace(contour, tolerance) is not { } place)
            {
                closed.Add(contour);
                continue;
            }

            united.Add(contour);
            unresolved.Add(place);
        }

        foreach (var group in OverlappingGroups.Find(closed, tolerance))
        {
            var result = UnionPass.Run(group, tolerance);
            united.AddRange(result.Contours);
            unresolved.AddRange(result.Unresolved);
        }

        return new UnionResult(united, unresolved);
    }

    /// <summary>The first place at which a contour is interrupted or has coordinates that are not numbers; null for a closed contour.</summary>
    private static Point2D? OpenPlace(IReadOnlyList<Segment> contour, double tolerance)
    {
        var end = contour[^1].End;
        foreach (var segment in contour)
        {
            if (segment.IsFreeCurve) throw new ArgumentException("A union has lines, arcs and circles only.", nameof(contour));
            if (!segment.Start.IsFinite || !segment.End.IsFinite || !end.IsNear(segment.Start, Math.Max(tolerance, Rounding(end)))) return segment.Start;
            end = segment.End;
        }

        return null;
    }

    private static double Rounding(Point2D place) => 1e-14 * (Math.Abs(place.X) + Math.Abs(place.Y));
}
