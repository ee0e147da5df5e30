using System.Numerics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>A hash grid of points (segment ends, midpoints) that finds the points within the tolerance of another in constant time.</summary>
/// <remarks>Cells are five times as wide as the tolerance, so at most four are searched, and two on average. The points of a cell are adjacent in memory,
/// because the segments of a drawing are in no spatial order; taken points are removed when the search reaches them.</remarks>
internal sealed class EndGrid
{
    /// <summary>No point is near (<see cref="OnlyNeighbours"/>).</summary>
    public const int None = -1;

    /// <summary>More than one point is near, or too many points would have to be tested.</summary>
    public const int Several = -2;

    /// <summary>Maximum number of points tested for one neighbour.</summary>
    private const int MaxForNeighbour = 64;
    private const int BitsForEach = 8;
    private const double CellInTolerances = 5.0;

    /// <summary>Binary logarithm of the number of blocks of buckets: the number of memory locations that can be written in turn without waiting.</summary>
    private const int BlockBits = 10;
    private const double OutermostCell = 1L << 60;

    /// <summary>For each bucket, the index of its first point and the number of remaining points.</summary>
    private readonly int[] _starts;
    private readonly int[] _counts;
    private readonly EndEntry[] _entries;

    /// <summary>One bit for each group of cells: 0 when all of them are empty, so that most queries of an empty cell need no further memory access.</summary>
    private readonly ulong[] _occupied;
    private readonly bool[] _taken;
    private readonly double _tolerance;
    private readonly double _cellsPerMillimetre;

    /// <param name="places">Points, numbered by their index.</param>
    /// <param name="tolerance">Tolerance in millimetres, zero or more: zero finds only exactly equal places.</param>
    public EndGrid(ReadOnlySpan<Point2D> places, double tolerance)
    {
        _tolerance = tolerance;
        _cellsPerMillimetre = 1.0 / Math.Max(CellInTolerances * tolerance, 1e-6);
        _starts = new int[(int)BitOperations.RoundUpToPowerOf2((uint)Math.Max(16, places.Length))];
        _counts = new int[_starts.Length];
        _occupied = new ulong[_starts.Length / (64 / BitsForEach)];
        _taken = new bool[places.Length];
        _entries = GC.AllocateUninitializedArray<EndEntry>(places.Length);
        Distribute(places);
    }

    /// <summary>Number of points that were tested.</summary>
    public long Comparisons { get; private set; }

    public void Take(int place) => _taken[place] = true;

    public bool IsTaken(int place) => _taken[place];

    /// <summary>For each place the only other one within the tolerance, <see cref="None"/>, or <see cref="Several"/>; taken points also count. Reads memory in
    /// order, while separate queries for each place would wait for memory each time.</summary>
    public int[] OnlyNeighbours()
    {
        var neighbours = GC.AllocateUninitializedArray<int>(_entries.Length);
        foreach (ref readonly var entry in _entries.AsSpan()) neighbours[entry.Place] = OnlyNeighbour(entry);
        return neighbours;
    }

    /// <summary>Replaces the content of <paramref name="found"/> by every place within the tolerance that is not taken.</summary>
    public void Near(Point2D here, List<int> found) => TryNear(here, _ => true, int.MaxValue, found);

    /// <summary>The same, limited to points for which <paramref name="counts"/> holds; false when more than <paramref name="most"/> would have to be tested:
    /// <paramref name="found"/> is then incomplete.</summary>
    public bool TryNear(Point2D here, Predicate<int> counts, int most, List<int> found)
    {
        found.Clear();
        foreach (var cell in CellsNear(here))
        {
            if (!TryNearInCell(cell, here, counts, ref most, found)) return false;
        }

        return true;
    }

    /// <summary>The one, two or four cells that can contain places within the tolerance.</summary>
    public CellRange CellsNear(Point2D here) => new(CellOf(here.X - _tolerance), CellOf(here.X + _tolerance), CellOf(here.Y - _tolerance), CellOf(here.Y + _tolerance));

    public (long X, long Y) CellAt(Point2D here) => (CellOf(here.X), CellOf(here.Y));

    /// <summary>The places of a cell that are not taken, in ascending order.</summary>
    public int[] PlacesIn((long X, long Y) cell)
    {
        var found = new List<int>();
        foreach (ref readonly var entry in BucketOf(HashOf(cell)))
        {
            Comparisons++;
            if (!_taken[entry.Place] && CellAt(entry.At) == cell) found.Add(entry.Place);
        }

        return [.. found];
    }

    private int OnlyNeighbour(in EndEntry of)
    {
        var (only, most) = (None, MaxForNeighbour);
        foreach (var cell in CellsNear(of.At))
        {
            var hash = HashOf(cell);
            if (!IsOccupied(hash)) continue;
            foreach (ref readonly var entry in BucketOf(hash))
            {
                Comparisons++;
                if (most-- == 0) return Several;
                if (entry.Place == of.Place || !entry.At.IsNear(of.At, _tolerance) || CellAt(entry.At) != cell) continue;
                if (only != None) return Several;
                only = entry.Place;
            }
        }

        return only;
    }

    private bool TryNearInCell((long X, long Y) cell, Point2D here, Predicate<int> counts, ref int most, List<int> found)
    {
        var hash = HashOf(cell);
        if (!IsOccupied(hash)) return true;
        var entries = BucketOf(hash);
        var kept = 0;
        for (var i = 0; i < entries.Length; i++)
        {
            Comparisons++;
            if (_taken[entries[i].Place]) continue;
            if (most-- == 0)
            {
                LeaveOut(hash, entries, kept, i);
                return false;
            }

            if (kept < i) entries[kept] = entries[i];
            ref readonly var entry = ref entries[kept++];
            if (entry.At.IsNear(here, _tolerance) && CellAt(entry.At) == cell && counts(entry.Place)) found.Add(entry.Place);
        }

        _counts[IndexOf(hash)] = kept;
        return true;
    }

    /// <summary>Removes the taken points among the first of a bucket; the remaining ones are moved up to the untested ones, so that a large bucket is not moved
    /// as a whole.</summary>
    private void LeaveOut(ulong hash, Span<EndEntry> entries, int kept, int tested)
    {
        entries[..kept].CopyTo(entries[(tested - kept)..]);
        var bucket = IndexOf(hash);
        _starts[bucket] += tested - kept;
        _counts[bucket] -= tested - kept;
    }

    /// <summary>Sorts the points by bucket; those of one bucket stay in ascending order. Sorts first by blocks of buckets, because writing spatially unordered
    /// points directly to their buckets would wait for memory each time.</summary>
    private void Distribute(ReadOnlySpan<Point2D> places)
    {
        var shift = Math.Max(0, BitOperations.Log2((uint)_starts.Length) - BlockBits);
        var blocks = new int[(_starts.Length >> shift) + 1];
        foreach (var place in places)
        {
            var hash = HashOf(CellAt(place));
            var bit = BitOf(hash);
            _occupied[bit >> 6] |= 1UL << (bit & 63);
            blocks[(IndexOf(hash) >> shift) + 1]++;
        }

        for (var block = 1; block < blocks.Length; block++) blocks[block] += blocks[block - 1];
        for (var i = 0; i < places.Length; i++)
        {
            var bucket = IndexOf(HashOf(CellAt(places[i])));
            _entries[blocks[bucket >> shift]++] = new EndEntry(places[i], i, bucket);
        }

        var (begin, unsorted) = (0, Array.Empty<EndEntry>());
        for (var block = 0; block < blocks.Length - 1; block++)
        {
            SortBlock(begin, blocks[block] - begin, (block << shift, 1 << shift), ref unsorted);
            begin = blocks[block];
        }
    }

    /// <param name="begin">The first entry of the block.</param>
    /// <param name="length">Number of its entries.</param>
    /// <param name="buckets">The first bucket of the block, and how many it has.</param>
    /// <param name="unsorted">Buffer for the unsorted entries; grows.</param>
    private void SortBlock(int begin, int length, (int First, int Count) buckets, ref EndEntry[] unsorted)
    {
        if (unsorted.Length < length) unsorted = new EndEntry[length];
        var entries = unsorted.AsSpan(0, length);
        _entries.AsSpan(begin, length).CopyTo(entries);
        var starts = _starts.AsSpan(buckets.First, buckets.Count);
        var counts = _counts.AsSpan(buckets.First, buckets.Count);
        foreach (ref readonly var entry in entries) counts[entry.Bucket - buckets.First]++;
        for (var bucket = 0; bucket < starts.Length; bucket++) (starts[bucket], begin) = (begin, begin + counts[bucket]);
        foreach (ref readonly var entry in entries) _entries[starts[entry.Bucket - buckets.First]++] = entry;
        for (var bucket = 0; bucket < starts.Length; bucket++) starts[bucket] -= counts[bucket];
    }

    private Span<EndEntry> BucketOf(ulong hash)
    {
        var bucket = IndexOf(hash);
        return _entries.AsSpan(_starts[bucket], _counts[bucket]);
    }

    /// <summary>The cell of a coordinate. Extreme coordinates share the outermost cell, because an overflowed number could not be found again.</summary>
    private long CellOf(double coordinate) => (long)Math.Floor(Math.Clamp(coordinate * _cellsPerMillimetre, -OutermostCell, OutermostCell));

    private int IndexOf(ulong hash) => (int)(hash >> 33) & (_starts.Length - 1);

    private bool IsOccupied(ulong hash)
    {
        var bit = BitOf(hash);
        return (_occupied[bit >> 6] & (1UL << (bit & 63))) != 0;
    }

    private int BitOf(ulong hash) => (int)((hash >> 24) & (((ulong)_occupied.Length * 64) - 1));

    private static ulong HashOf((long X, long Y) cell)
    {
        var hash = ((ulong)cell.X * 0x9E3779B97F4A7C15UL) ^ ((ulong)cell.Y * 0xC2B2AE3D27D4EB4FUL);
        return (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9UL;
    }

    private readonly record struct EndEntry(Point2D At, int Place, int Bucket);

    /// <summary>The cells of a small rectangle, column by column.</summary>
    public readonly record struct CellRange(long Left, long Right, long Lower, long Upper)
    {
        public Enumerator GetEnumerator() => new(this);

        public (long X, long Y)[] ToArray()
        {
            var cells = new List<(long X, long Y)>();
            foreach (var cell in this) cells.Add(cell);
            return [.. cells];
        }

        public struct Enumerator(CellRange cells)
        {
            private long _x = cells.Left;
            private long _y = cells.Lower - 1;

            public readonly (long X, long Y) Current => (_x, _y);

            public bool MoveNext()
            {
                if (++_y <= cells.Upper) return true;
                _y = cells.Lower;
                return ++_x <= cells.Right;
            }
        }
    }
}
