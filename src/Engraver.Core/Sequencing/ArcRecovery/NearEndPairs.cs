using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Finds every pair of segment ends within a distance of each other. Ends are first sorted into squares, so that memory is read in order.</summary>
/// <remarks>End number 2 x row is a segment's start, 2 x row + 1 its end. An end near the side of its square is also put into the neighbour, so that a pair can
/// be reported twice.</remarks>
internal sealed class NearEndPairs
{
    private const int EndsPerSquare = 4;

    /// <summary>Maximum number of ends in one square: more do not occur in a drawing of lines end to end, and comparing all pairs would take too
    /// long.</summary>
    private const int MaxInSquare = 256;

    private readonly double _distance;
    private readonly double _size;
    private readonly Point2D _corner;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _first;
    private readonly (Point2D Place, int End)[] _sorted;

    public NearEndPairs(Segment[] segments, double distance)
    {
        _distance = distance;
        var box = Bounds2D.Empty;
        foreach (var segment in segments)
        {
            if (!segment.IsClosed) box = box.Union(Bounds2D.FromCorners(segment.Start, segment.End));
        }

        if (box.IsEmpty) box = Bounds2D.FromCorners(default, default);
        _corner = new Point2D(box.MinX, box.MinY);
        _size = Math.Max(8.0 * distance, Math.Sqrt(box.Width * box.Height * EndsPerSquare / Math.Max(1.0, 2.0 * segments.Length)));
        _size = Math.Max(_size, (box.Width + box.Height) / Math.Max(16.0, segments.Length)); // a flat box: not more squares than ends
        _columns = Number(box.MaxX, _corner.X) + 1;
        _rows = Number(box.MaxY, _corner.Y) + 1;
        _first = new int[(_columns * _rows) + 1];
        Visit(segments, (_, _, square) => _first[square + 1]++);
        for (var square = 0; square < _columns * _rows; square++)
        {
            IsCrowded |= _first[square + 1] > MaxInSquare;
            _first[square + 1] += _first[square];
        }

        _sorted = new (Point2D, int)[_first[^1]];
        var next = _first.AsSpan(0, _first.Length - 1).ToArray();
        Visit(segments, (place, end, square) => _sorted[next[square]++] = (place, end));
    }

    /// <summary>True when a square has too many ends to compare every pair.</summary>
    public bool IsCrowded { get; }

    /// <summary>Passes on each pair of ends of different segments.</summary>
    public void Visit(Action<int, int> take)
    {
        for (var square = 0; square + 1 < _first.Length; square++)
        {
            var ends = _sorted.AsSpan(_first[square], _first[square + 1] - _first[square]);
            for (var i = 1; i < ends.Length; i++)
            {
                for (var j = 0; j < i; j++)
                {
                    if (ends[i].Place.IsNear(ends[j].Place, _distance) && ends[i].End / 2 != ends[j].End / 2) take(ends[i].End, ends[j].End);
                }
            }
        }
    }

    private void Visit(Segment[] segments, Action<Point2D, int, int> take)
    {
        for (var row = 0; row < segments.Length; row++)
        {
            if (segments[row].IsClosed) continue;
            Visit(segments[row].Start, 2 * row, take);
            Visit(segments[row].End, (2 * row) + 1, take);
        }
    }

    private void Visit(Point2D place, int end, Action<Point2D, int, int> take)
    {
        var (left, right) = (Number(place.X - _distance, _corner.X), Math.Min(_columns - 1, Number(place.X + _distance, _corner.X)));
        var (lower, upper) = (Number(place.Y - _distance, _corner.Y), Math.Min(_rows - 1, Number(place.Y + _distance, _corner.Y)));
        for (var x = left; x <= right; x++)
        {
            for (var y = lower; y <= upper; y++) take(place, end, (x * _rows) + y);
        }
    }

    private int Number(double coordinate, double corner) => (int)Math.Clamp((coordinate - corner) / _size, 0.0, 1 << 20);
}
