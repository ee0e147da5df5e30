using System.Runtime.InteropServices;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Follows segments until every segment is in a contour. End number 2 x row is a segment's start, 2 x row + 1 its end.</summary>
internal sealed class ContourWalker
{
    /// <summary>Two continuations whose cosines differ by less are equally straight; the lower row is preferred.</summary>
    private const double SameTurnCosine = 1e-9;

    /// <summary>A contour with a length of at most twice the tolerance is closed when its ends are nearer to each other than this fraction of its
    /// length.</summary>
    private const double SmallContourGap = 1e-3;

    private readonly Segment[] _segments;
    private readonly double _tolerance;
    private readonly EndHeights _heights;
    private readonly EndGrid _ends;
    private readonly bool[] _used;
    private readonly CrowdedJunctions _crowded;
    private readonly int[] _onlyNeighbours;
    private readonly List<int> _near = [];
    private readonly List<ContourPiece> _ahead = [];
    private readonly List<ContourPiece> _behind = [];
    private readonly PieceMemory _pieces = new();
    private readonly Predicate<int> _counts;
    private int _closingRow;
    private int _level;

    public ContourWalker(Segment[] segments, double joinTolerance, EndHeights heights)
        : this(segments, new SegmentEnds(segments, joinTolerance), joinTolerance, heights)
    {
    }

    /// <param name="segments">Rows by index.</param>
    /// <param name="ends">Ends of the segments, within the join tolerance; the walk consumes them.</param>
    /// <param name="joinTolerance">Join tolerance, millimetres.</param>
    /// <param name="heights">Heights of the ends.</param>
    public ContourWalker(Segment[] segments, SegmentEnds ends, double joinTolerance, EndHeights heights)
    {
        _segments = segments;
        _tolerance = joinTolerance;
        _heights = heights;
        _used = new bool[segments.Length];
        (_ends, _onlyNeighbours) = (ends.Grid, ends.OnlyNeighbours);
        _crowded = new CrowdedJunctions(_ends, ends.Places, joinTolerance);
        _counts = end => (!_used[end / 2] || end / 2 == _closingRow) && (_heights.AreFlat || _heights.LevelOf(end) == _level);
        for (var row = 0; row < segments.Length; row++)
        {
            if (segments[row].IsClosed) TakeEnds(row);
        }
    }

    /// <summary>Number of times a continuation had to be chosen from several.</summary>
    public int Branches { get; private set; }

    /// <summary>Ends and boxes of ends that were tested.</summary>
    public long Comparisons => _ends.Comparisons + _crowded.Comparisons;

    public List<Contour> WalkAll()
    {
        var contours = new List<Contour>();
        for (var row = 0; row < _segments.Length; row++)
        {
            if (!_used[row]) contours.Add(_segments[row].IsClosed ? SinglePiece(row) : WalkFrom(row));
        }

        return contours;
    }

    /// <summary>The contour of a single closed segment: a circle, a full ellipse, a closed spline.</summary>
    private Contour SinglePiece(int row)
    {
        _used[row] = true;
        var pieces = _pieces.Take(1);
        pieces.Span[0] = new ContourPiece(row, Reversed: false);
        return new Contour(pieces, Closed: true);
    }

    private Contour WalkFrom(int row)
    {
        var first = new ContourPiece(row, Reversed: false);
        _used[row] = true;
        _ends.Take((2 * row) + 1); // the start stays in the grid: reaching it again closes the contour
        var isClosed = Grow(_ahead, first, row);
        if (isClosed) _behind.Clear();
        else GrowBehind(first);
        var before = Math.Max(0, _behind.Count - 1);
        var pieces = _pieces.Take(before + _ahead.Count);
        for (var i = 1; i <= before; i++) pieces.Span[before - i] = _behind[i].Turned();
        CollectionsMarshal.AsSpan(_ahead).CopyTo(pieces.Span[before..]);
        return new Contour(pieces, isClosed);
    }

    private void GrowBehind(ContourPiece first)
    {
        _ends.Take(2 * first.Row);
        Grow(_behind, first.Turned(), closingRow: -1);
    }

    /// <summary>Appends continuations of a first piece until there are no more. True when the contour reached the start of <paramref name="closingRow"/>
    /// again.</summary>
    private bool Grow(List<ContourPiece> pieces, ContourPiece first, int closingRow)
    {
        pieces.Clear();
        pieces.Add(first);
        var length = _segments[first.Row].Length;
        while (Next(pieces[^1], IsLong(length) || EndsMeet(pieces, length) ? closingRow : -1) is { } next)
        {
            if (next.Row == closingRow)
            {
                _ends.Take(2 * closingRow);
                return true;
            }

            pieces.Add(next);
            if (!IsLong(length)) length += _segments[next.Row].Length; // the exact length of a long contour is irrelevant, and the segment need not be read
            _used[next.Row] = true;
            TakeEnds(next.Row);
        }

        return false;
    }

    private bool IsLong(double length) => length > 2.0 * _tolerance;

    private bool EndsMeet(List<ContourPiece> pieces, double length) => length > 0.0 && pieces[0].StartIn(_segments).DistanceTo(pieces[^1].EndIn(_segments)) <= SmallContourGap * length;

    private void TakeEnds(int row)
    {
        _ends.Take(2 * row);
        _ends.Take((2 * row) + 1);
    }

    /// <summary>The next piece, or null. In a contour with a length of at most twice the tolerance the start is always near the end: it closes only where the
    /// two actually meet.</summary>
    private ContourPiece? Next(ContourPiece last, int closingRow)
    {
        (_closingRow, _level) = (closingRow, _heights.LevelOf(last.EndNumber));
        var only = _onlyNeighbours[last.EndNumber];
        if (only != EndGrid.Several) return only != EndGrid.None && !_ends.IsTaken(only) && _counts(only) ? PieceFrom(only) : null;
        var here = last.EndIn(_segments);
        if (!_ends.TryNear(here, _counts, CrowdedJunctions.Crowd, _near)) return NextInCrowd(here, TravelAtEnd(last));
        if (_near.Count == 0) return null;
        var isBranch = _near.Exists(end => end / 2 != _near[0] / 2);
        if (isBranch) Branches++;
        return PieceFrom(ShortestDetour(here) ?? (isBranch ? Straightest(here, TravelAtEnd(last)) : NearerEnd(here)));
    }

    private static ContourPiece PieceFrom(int end) => new(end / 2, Reversed: (end & 1) == 1);

    /// <summary>The same choice when too many ends are near to test each of them.</summary>
    private ContourPiece? NextInCrowd(Point2D here, Vector2D travel)
    {
        var junctions = _crowded.Near(here, _level, IsAtLevel, IsShort, TravelInto);
        var detour = _crowded.NearestShort(junctions, here, _counts);
        var straightest = detour is null ? _crowded.Straightest(junctions, here, travel, SameTurnCosine, _counts) : null;
        if ((detour ?? straightest?.End) is not { } end) return null;
        var isBranch = _crowded.IsAny(junctions, here, other => other / 2 != end / 2 && _counts(other));
        if (isBranch) Branches++;
        return PieceFrom(detour ?? NearerOf(end, here, travel, isBranch ? straightest!.Value.Cosine - SameTurnCosine : double.NegativeInfinity));
    }

    /// <summary>True when the given end, or the other end of its segment if that is nearer, can also be chosen and is straight enough.</summary>
    private int NearerOf(int end, Point2D here, Vector2D travel, double leastCosine)
    {
        var other = end ^ 1;
        var canBe = _counts(other) && !_ends.IsTaken(other) && PlaceOf(other).IsNear(here, _tolerance) && travel.Dot(TravelInto(other)) >= leastCosine;
        return canBe && IsNearer(other, end, here) ? other : end;
    }

    private bool IsAtLevel(int end) => _heights.LevelOf(end) == _level;

    private bool IsShort(int end) => _segments[end / 2].Length <= _tolerance;

    private int? ShortestDetour(Point2D here)
    {
        int? best = null;
        foreach (var end in _near)
        {
            if (IsShort(end) && (best is not { } other || IsNearer(end, other, here))) best = end;
        }

        return best;
    }

    /// <summary>The nearer end of the only candidate segment; its start when both are equally near.</summary>
    private int NearerEnd(Point2D here) => _near.Count == 1 || IsNearer(_near[0], _near[1], here) ? _near[0] : _near[1];

    private bool IsNearer(int end, int other, Point2D here)
    {
        var difference = here.DistanceTo(PlaceOf(end)) - here.DistanceTo(PlaceOf(other));
        return difference < 0.0 || (difference == 0.0 && end < other);
    }

    private int Straightest(Point2D here, Vector2D travel)
    {
        var straightest = _near.Max(end => travel.Dot(TravelInto(end)));
        var best = -1;
        foreach (var end in _near)
        {
            if (travel.Dot(TravelInto(end)) < straightest - SameTurnCosine) continue;
            if (best < 0 || end / 2 < best / 2 || (end / 2 == best / 2 && IsNearer(end, best, here))) best = end;
        }

        return best;
    }

    private Point2D PlaceOf(int end) => (end & 1) == 0 ? _segments[end / 2].Start : _segments[end / 2].End;

    private Vector2D TravelAtEnd(ContourPiece piece) => piece.Reversed ? -_segments[piece.Row].StartTangent : _segments[piece.Row].EndTangent;

    private Vector2D TravelInto(int end) => (end & 1) == 0 ? _segments[end / 2].StartTangent : -_segments[end / 2].EndTangent;

    /// <summary>Allocates parts of large arrays: separate arrays for a million contours would be a million additional objects.</summary>
    private sealed class PieceMemory
    {
        private const int PiecesInBlock = 4096;
        private Memory<ContourPiece> _free;

        public Memory<ContourPiece> Take(int count)
        {
            if (count >= PiecesInBlock) return new ContourPiece[count];
            if (count > _free.Length) _free = new ContourPiece[PiecesInBlock];
            var taken = _free[..count];
            _free = _free[count..];
            return taken;
        }
    }
}
