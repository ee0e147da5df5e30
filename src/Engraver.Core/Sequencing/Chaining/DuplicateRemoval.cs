using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Removes duplicate segments: finds whole segments that coincide, in the same or the opposite direction.</summary>
public static class DuplicateRemoval
{
    /// <summary>Points compared on each span of a curve.</summary>
    private const int CurvePlaces = 8;

    /// <summary>Rows that are kept, ascending: of every group of duplicates the lowest row.</summary>
    /// <param name="segments">Rows by index.</param>
    /// <param name="tolerance">Tolerance, millimetres. Ends and midpoint must agree within it (for circles, the sum of the distance of the centres and the
    /// difference of the radii), or within a hundredth of the segment's length when that is less, so that a curve of tiny steps keeps every step. Removed
    /// segments are within this distance of the remaining ones.</param>
    public static int[] Keep(ReadOnlySpan<Segment> segments, double tolerance) => Keep(segments, tolerance, EndHeights.Flat);

    /// <param name="segments">Rows by index.</param>
    /// <param name="tolerance">Tolerance as above.</param>
    /// <param name="heights">Heights of the ends: segments at different levels are not duplicates.</param>
    public static int[] Keep(ReadOnlySpan<Segment> segments, double tolerance, EndHeights heights)
    {
        ArgumentNullException.ThrowIfNull(heights);
        return Keep(segments, tolerance, heights, [.. Enumerable.Range(0, segments.Length)]);
    }

    /// <param name="segments">Rows by index.</param>
    /// <param name="tolerance">Tolerance as above.</param>
    /// <param name="heights">Heights of the ends.</param>
    /// <param name="candidates">The rows that can coincide with another one, ascending: the others are kept without a check.</param>
    internal static int[] Keep(ReadOnlySpan<Segment> segments, double tolerance, EndHeights heights, int[] candidates)
    {
        var middles = new Point2D[candidates.Length];
        for (var i = 0; i < middles.Length; i++) middles[i] = MiddleOf(segments[candidates[i]]);
        var grid = new EndGrid(middles, tolerance);
        var neighbours = grid.OnlyNeighbours();
        var near = new List<int>();
        var isDuplicate = new bool[segments.Length];
        for (var i = 0; i < candidates.Length; i++)
        {
            var row = candidates[i];
            if (isDuplicate[row]) continue;
            grid.Take(i);
            if (neighbours[i] == EndGrid.None) continue;
            grid.Near(middles[i], near);
            foreach (var other in near)
            {
                var otherRow = candidates[other];
                if (!AreAsHigh(heights, row, otherRow) || !AreSame(segments[row], segments[otherRow], middles[i].DistanceTo(middles[other]), tolerance)) continue;
                isDuplicate[otherRow] = true;
                grid.Take(other);
            }
        }

        return [.. Enumerable.Range(0, segments.Length).Where(row => !isDuplicate[row])];
    }

    /// <summary>Compares the heights of both ends, in the same or the opposite direction.</summary>
    private static bool AreAsHigh(EndHeights heights, int row, int other)
    {
        var (start, end, otherStart, otherEnd) = (heights.LevelOf(2 * row), heights.LevelOf((2 * row) + 1), heights.LevelOf(2 * other), heights.LevelOf((2 * other) + 1));
        return (start == otherStart && end == otherEnd) || (start == otherEnd && end == otherStart);
    }

    /// <summary>The midpoint; for a circle its left quadrant point, so that concentric circles are in different cells of the grid.</summary>
    internal static Point2D MiddleOf(Segment segment) => segment.Kind == SegmentKind.Circle ? segment.Arc.Centre - new Vector2D(segment.Arc.Radius, 0.0) : segment.PointAt(0.5);

    /// <summary>True when two whole segments coincide in plan, in the same or the opposite direction.</summary>
    /// <param name="middleDistance">Distance of their <see cref="MiddleOf"/> points, millimetres.</param>
    internal static bool AreSame(Segment a, Segment b, double middleDistance, double tolerance)
    {
        if (a.Kind != b.Kind) return false;
        var within = Math.Min(tolerance, 0.01 * a.Length);
        if (middleDistance > within) return false;
        if (a.Kind == SegmentKind.Circle) return a.Arc.Centre.DistanceTo(b.Arc.Centre) + Math.Abs(a.Arc.Radius - b.Arc.Radius) <= within;
        if (a.IsFreeCurve) return RunTogether(a, b, within, backwards: false) || RunTogether(a, b, within, backwards: true);
        return (a.Start.IsNear(b.Start, within) && a.End.IsNear(b.End, within)) || (a.Start.IsNear(b.End, within) && a.End.IsNear(b.Start, within));
    }

    /// <summary>True when two curves with the same number of spans coincide; compared at points along the whole curve, because ends and middle do not
    /// distinguish them.</summary>
    private static bool RunTogether(Segment a, Segment b, double within, bool backwards)
    {
        var places = CurvePlaces * a.Curve.Spans.Length;
        if (a.Curve.Spans.Length != b.Curve.Spans.Length) return false;
        for (var i = 0; i <= places; i++)
        {
            var fraction = (double)i / places;
            if (!a.PointAt(fraction).IsNear(b.PointAt(backwards ? 1.0 - fraction : fraction), within)) return false;
        }

        return true;
    }
}
