using System.Numerics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>A hash grid of points (segment ends, midpoints) that finds the points within the tolerance of another in constant time.</summary>
/// <remarks>Cells are a little wider than twice the tolerance, so at most four are searched. Points that were taken are removed as they are met.</remarks>
internal sealed class EndGrid
{
    private const int None = -1;
    private const int BitsForEach = 8;
    private const double OutermostCell = 1L << 60;
    private readonly Point2D[] _places;
    private readonly int[] _heads;
    private readonly int[] _next;

    /// <summary>One bit for some cells each: 0 where all of them are empty, so that most looks at an empty cell end without a walk through the memory.</summary>
    private readonly ulong[] _occupied;
    private readonly bool[] _taken;
    private readonly double _tolerance;
    private readonly double _cell;

    /// <param name="places">Numbered by their index.</param>
    /// <param name="tolerance">Millimetres, zero or more: zero finds exactly equal places only.</param>
    public EndGrid(Point2D[] places, double tolerance)
    {
        _places = places;
        _tolerance = tolerance;
        _cell = Math.Max(2.5 * tolerance, 1e-6);
        _heads = new int[(int)BitOperations.RoundUpToPowerOf2((uint)Math.Max(16, places.Length))];
        _next = new int[places.Length];
        _occupied = new ulong[_heads.Length / (64 / BitsForEach)];
        _taken = new bool[places.Length];
        Array.Fill(_heads, None);
        for (var i = places.Length - 1; i >= 0; i--) Link(i);
    }

    /// <summary>Number of points that were tested.</summary>
    public long Looks { get; private set; }

    public void Take(int place) => _taken[place] = true;

    public bool IsTaken(int place) => _taken[place];

    /// <summary>Replaces the content of <paramref name="found"/> by every place within the tolerance that is not taken.</summary>
    public void Near(Point2D here, List<int> found) => TryNear(here, _ => true, int.MaxValue, found);

    /// <summary>The same, limited to points for which <paramref name="counts"/> holds; false when more than <paramref name="most"/> would have to be tested: <paramref name="found"/> is then incomplete.</summary>
    public bool TryNear(Point2D here, Predicate<int> counts, int most, List<int> found)
    {
        found.Clear();
        var (left, right) = (CellOf(here.X - _tolerance), CellOf(here.X + _tolerance));
        var (lower, upper) = (CellOf(here.Y - _tolerance), CellOf(here.Y + _tolerance));
        for (var x = left; x <= right; x++)
        {
            for (var y = lower; y <= upper; y++)
            {
                if (!TryNearInCell(x, y, here, counts, ref most, found)) return false;
            }
        }

        return true;
    }

    /// <summary>The one, two or four cells in which places within the tolerance may lie.</summary>
    public IEnumerable<(long X, long Y)> CellsNear(Point2D here)
    {
        var (left, right) = (CellOf(here.X - _tolerance), CellOf(here.X + _tolerance));
        var (lower, upper) = (CellOf(here.Y - _tolerance), CellOf(here.Y + _tolerance));
        for (var x = left; x <= right; x++)
        {
            for (var y = lower; y <= upper; y++) yield return (x, y);
        }
    }

    public (long X, long Y) CellAt(Point2D here) => (CellOf(here.X), CellOf(here.Y));

    /// <summary>The places of a cell that are not taken, in ascending order.</summary>
    public int[] PlacesIn((long X, long Y) cell)
    {
        var found = new List<int>();
        for (var i = _heads[Bucket(cell.X, cell.Y)]; i != None; i = _next[i])
        {
            Looks++;
            if (!_taken[i] && IsIn(i, cell.X, cell.Y)) found.Add(i);
        }

        return [.. found];
    }

    private bool IsIn(int place, long x, long y) => CellOf(_places[place].X) == x && CellOf(_places[place].Y) == y;

    private bool TryNearInCell(long x, long y, Point2D here, Predicate<int> counts, ref int most, List<int> found)
    {
        var hash = HashOf(x, y);
        if (!IsOccupied(hash)) return true;
        var previous = None;
        var head = (int)(hash >> 33) & (_heads.Length - 1);
        for (var i = _heads[head]; i != None; i = _next[i])
        {
            Looks++;
            if (_taken[i])
            {
                if (previous == None) _heads[head] = _next[i];
                else _next[previous] = _next[i];
                continue;
            }

            previous = i;
            if (most-- == 0) return false;
            if (_places[i].IsNear(here, _tolerance) && IsIn(i, x, y) && counts(i)) found.Add(i);
        }

        return true;
    }

    private void Link(int i)
    {
        var hash = HashOf(CellOf(_places[i].X), CellOf(_places[i].Y));
        var (bucket, bit) = ((int)(hash >> 33) & (_heads.Length - 1), BitOf(hash));
        _occupied[bit >> 6] |= 1UL << (bit & 63);
        _next[i] = _heads[bucket];
        _heads[bucket] = i;
    }

    /// <summary>The cell of a coordinate. Extreme coordinates share the outermost cell, because a number that overflowed would never be found again.</summary>
    private long CellOf(double coordinate) => (long)Math.Floor(Math.Clamp(coordinate / _cell, -OutermostCell, OutermostCell));

    private int Bucket(long x, long y) => (int)(HashOf(x, y) >> 33) & (_heads.Length - 1);

    private bool IsOccupied(ulong hash)
    {
        var bit = BitOf(hash);
        return (_occupied[bit >> 6] & (1UL << (bit & 63))) != 0;
    }

    private int BitOf(ulong hash) => (int)((hash >> 24) & (((ulong)_occupied.Length * 64) - 1));

    private static ulong HashOf(long x, long y)
    {
        var hash = ((ulong)x * 0x9E3779B97F4A7C15UL) ^ ((ulong)y * 0xC2B2AE3D27D4EB4FUL);
        return (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9UL;
    }
}
