using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The ends of segments in a grid, with what lies near each. End number 2 x row is a segment's start, 2 x row + 1 its end.</summary>
internal sealed class SegmentEnds
{
    private readonly double _tolerance;

    /// <param name="segments">Rows by index.</param>
    /// <param name="tolerance">Within which two ends are near, millimetres.</param>
    public SegmentEnds(Segment[] segments, double tolerance)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(tolerance);
        _tolerance = tolerance;
        Places = GC.AllocateUninitializedArray<Point2D>(2 * segments.Length);
        for (var row = 0; row < segments.Length; row++) (Places[2 * row], Places[(2 * row) + 1]) = (segments[row].Start, segments[row].End);
        Grid = new EndGrid(Places, tolerance);
        OnlyNeighbours = Grid.OnlyNeighbours();
    }

    public Point2D[] Places { get; }

    public EndGrid Grid { get; }

    /// <summary>For each end what <see cref="EndGrid.OnlyNeighbours"/> says: at most junctions the one segment that goes on, so that nothing need be searched.</summary>
    public int[] OnlyNeighbours { get; }

    /// <summary>The rows that may coincide with another one within <paramref name="tolerance"/>, ascending; null when that cannot be told from the ends. The others have an end where no other segment ends, or ends at two different segments.</summary>
    public int[]? MayCoincide(Segment[] segments, double tolerance)
    {
        if (tolerance > _tolerance) return null;
        var rows = new List<int>();
        for (var row = 0; row < segments.Length; row++)
        {
            if (MayCoincide(row) || segments[row].Kind is not (SegmentKind.Line or SegmentKind.Arc)) rows.Add(row);
        }

        return [.. rows];
    }

    private bool MayCoincide(int row)
    {
        var (start, end) = (OnlyNeighbours[2 * row], OnlyNeighbours[(2 * row) + 1]);
        if (start == EndGrid.None || end == EndGrid.None) return false;
        return start == EndGrid.Several || end == EndGrid.Several || start / 2 == end / 2;
    }
}
