using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The ends of segments in a grid, with the neighbours of each. End number 2 x row is a segment's start, 2 x row + 1 its end.</summary>
internal sealed class SegmentEnds
{
    private readonly double _tolerance;

    /// <param name="segments">Rows by index.</param>
    /// <param name="tolerance">Distance within which two ends are near, millimetres.</param>
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

    /// <summary>For each end the result of <see cref="EndGrid.OnlyNeighbours"/>: at most junctions the single continuing segment, which makes a search
    /// unnecessary.</summary>
    public int[] OnlyNeighbours { get; }

    /// <summary>The rows that can coincide with another one within <paramref name="tolerance"/>, ascending; null when the ends do not determine this. The
    /// others have an end where no other segment ends, or ends at two different segments.</summary>
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
