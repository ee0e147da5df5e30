using System.Numerics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Places in square cells, about two to a cell: the nearest one is mostly found in a few cells, otherwise through larger squares that store their
/// number of shown places.</summary>
/// <remarks>For evenly spread places, many times faster than a <see cref="BoxTree"/>; no grid is made for other places. Places can be hidden and shown again.
/// Not safe for use from several threads while places are hidden or shown.</remarks>
internal sealed class PlaceGrid
{
    private const double PlacesInCell = 2.0;

    /// <summary>Limit of the number of places in the cell of a place, as the mean over all places: above it, the places are crowded and a tree is
    /// faster.</summary>
    private const double MaxInCell = 24.0;

    /// <summary>Number of cells to either side that are searched before larger squares.</summary>
    private const int Rings = 3;

    /// <summary>Number of squares of a level along the side of a square of the next level.</summary>
    private const int Fanout = 4;

    /// <summary>Largest rounding of the edges of a cell, as a fraction of the cell.</summary>
    private const double MaxMargin = 0.25;

    /// <summary>Accuracy of squared distances.</summary>
    private const double Rounding = 1e-9;

    private readonly Bounds2D _bounds;
    private readonly double _cell;
    private readonly int _columns;
    private readonly int _rows;

    /// <summary>Margin for the rounding of a cell's edges, millimetres.</summary>
    private readonly double _margin;

    /// <summary>The first entry of each cell; one element more than there are cells.</summary>
    private readonly int[] _starts;

    /// <summary>For each cell, the number of its entries, from the first, that are shown: the lowest level.</summary>
    private readonly int[] _shown;
    private readonly Level[] _levels;
    private readonly PlaceEntry[] _entries;

    /// <summary>The entry of each place.</summary>
    private readonly int[] _entryOf;

    private PlaceGrid(ReadOnlySpan<Point2D> places, Bounds2D bounds, double cell, int columns, int rows)
    {
        (_bounds, _cell, _columns, _rows) = (bounds, cell, columns, rows);
        _margin = MarginOf(bounds, cell);
        _starts = new int[(columns * rows) + 1];
        _shown = new int[columns * rows];
        _entries = GC.AllocateUninitializedArray<PlaceEntry>(places.Length);
        _entryOf = GC.AllocateUninitializedArray<int>(places.Length);
        Distribute(places);
        _levels = LevelsOver(new Level(_shown, columns, rows, cell));
    }

    /// <summary>A grid of places, all shown, numbered by their index; null when they are crowded, coincide, or are so far from zero that cells cannot be
    /// distinguished.</summary>
    public static PlaceGrid? TryBuild(ReadOnlySpan<Point2D> places)
    {
        var bounds = Bounds2D.Empty;
        foreach (var place in places) bounds = bounds.Including(place);
        var (width, height) = (bounds.MaxX - bounds.MinX, bounds.MaxY - bounds.MinY);
        var cells = Math.Max(1.0, places.Length / PlacesInCell);
        var cell = Math.Max(Math.Sqrt(width * height / cells), Math.Max(width, height) / cells);
        if (!double.IsFinite(cell) || !(cell > 0.0)) return null;
        if (MarginOf(bounds, cell) > MaxMargin * cell) return null;
        var grid = new PlaceGrid(places, bounds, cell, (int)(width / cell) + 1, (int)(height / cell) + 1);
        return grid.IsEven() ? grid : null;
    }

    /// <summary>The shown places cell by cell: in this order, consecutive queries use the same memory.</summary>
    public IEnumerable<int> ByCell()
    {
        for (var cell = 0; cell < _shown.Length; cell++)
        {
            for (var entry = _starts[cell]; entry < _starts[cell] + _shown[cell]; entry++) yield return _entries[entry].Place;
        }
    }

    /// <summary>Excludes a place from every result until it is shown again. Hiding it twice has no further effect.</summary>
    public void Hide(int place)
    {
        var entry = _entryOf[place];
        var (column, row) = CellOf(_entries[entry].At);
        var cell = (row * _columns) + column;
        var last = _starts[cell] + _shown[cell] - 1;
        if (entry > last) return;
        Swap(entry, last);
        Count(column, row, -1);
    }

    public void Show(int place)
    {
        var entry = _entryOf[place];
        var (column, row) = CellOf(_entries[entry].At);
        var cell = (row * _columns) + column;
        var next = _starts[cell] + _shown[cell];
        if (entry < next) return;
        Swap(entry, next);
        Count(column, row, 1);
    }

    /// <summary>The nearest shown place, of equally near ones the lower number; -1 when no shown place is within the distance.</summary>
    /// <param name="from">Point to measure from.</param>
    /// <param name="except">A place to exclude; -1 for none.</param>
    /// <param name="within">Largest distance of interest; positive infinity for any.</param>
    /// <param name="distance">Distance of the result; <paramref name="within"/> when there is none.</param>
    public int Nearest(Point2D from, int except, double within, out double distance)
    {
        var best = new NearestPlace(within);
        if (!TryRings(from, except, ref best)) Descend(_levels.Length - 1, 0, 0, from, except, ref best);
        distance = best.Distance;
        return best.Place;
    }

    private static Level[] LevelsOver(Level cells)
    {
        var levels = new List<Level> { cells };
        while (levels[^1].Shown.Length > 1)
        {
            var below = levels[^1];
            var (columns, rows) = ((below.Columns + Fanout - 1) / Fanout, (below.Rows + Fanout - 1) / Fanout);
            var shown = new int[columns * rows];
            for (var row = 0; row < below.Rows; row++)
            {
                for (var column = 0; column < below.Columns; column++) shown[(row / Fanout * columns) + (column / Fanout)] += below.Shown[(row * below.Columns) + column];
            }

            levels.Add(new Level(shown, columns, rows, below.Side * Fanout));
        }

        return [.. levels];
    }

    private void Count(int column, int row, int more)
    {
        foreach (var level in _levels)
        {
            level.Shown[(row * level.Columns) + column] += more;
            (column, row) = (column / Fanout, row / Fanout);
        }
    }

    /// <returns>False when the surrounding cells do not determine the nearest place.</returns>
    private bool TryRings(Point2D from, int except, ref NearestPlace best)
    {
        var (column, row) = CellOf(from);
        for (var ring = 0; ring <= Rings; ring++)
        {
            TestRing(column, row, ring, from, except, ref best);
            if (best.Distance < Beyond(column, row, ring, from)) return true;
        }

        return false;
    }

    /// <summary>Searches a square for a nearer place, starting with the nearest of the squares in it.</summary>
    private void Descend(int level, int column, int row, Point2D from, int except, ref NearestPlace best)
    {
        if (level == 0)
        {
            TestCell((row * _columns) + column, from, except, ref best);
            return;
        }

        var below = _levels[level - 1];
        Span<double> distances = stackalloc double[Fanout * Fanout];
        var left = 0u; // a bit for each square in it that must still be searched
        for (var i = 0; i < distances.Length; i++)
        {
            var (x, y) = ((column * Fanout) + (i % Fanout), (row * Fanout) + (i / Fanout));
            if (x >= below.Columns || y >= below.Rows || below.Shown[(y * below.Columns) + x] == 0) continue;
            distances[i] = DistanceTo(below.Side, x, y, from);
            left |= 1u << i;
        }

        while (left != 0)
        {
            var nearest = IndexOfSmallest(distances, left);
            if (distances[nearest] > best.Distance) return;
            left &= ~(1u << nearest);
            Descend(level - 1, (column * Fanout) + (nearest % Fanout), (row * Fanout) + (nearest / Fanout), from, except, ref best);
        }
    }

    /// <summary>Lower bound of the distance of a place in a square.</summary>
    private double DistanceTo(double side, int column, int row, Point2D from)
    {
        var (left, low) = (_bounds.MinX + (column * side), _bounds.MinY + (row * side));
        var x = Math.Max(0.0, Math.Max(left - from.X, from.X - left - side));
        var y = Math.Max(0.0, Math.Max(low - from.Y, from.Y - low - side));
        return (double.Hypot(x, y) * (1.0 - Rounding)) - (2.0 * _margin);
    }

    private static double MarginOf(in Bounds2D bounds, double cell) =>
        (1e-6 * cell) + (1e-12 * Math.Max(Math.Max(Math.Abs(bounds.MinX), Math.Abs(bounds.MaxX)), Math.Max(Math.Abs(bounds.MinY), Math.Abs(bounds.MaxY))));

    /// <param name="of">A bit for each value to consider; at least one.</param>
    private static int IndexOfSmallest(ReadOnlySpan<double> values, uint of)
    {
        var smallest = BitOperations.TrailingZeroCount(of);
        for (var rest = of & (of - 1); rest != 0; rest &= rest - 1)
        {
            var i = BitOperations.TrailingZeroCount(rest);
            if (values[i] < values[smallest]) smallest = i;
        }

        return smallest;
    }

    private static int Clamped(double cell, int count) => cell > 0.0 ? (int)Math.Min(cell, count - 1) : 0;

    private void Distribute(ReadOnlySpan<Point2D> places)
    {
        foreach (var place in places) _shown[IndexOf(place)]++;
        for (var cell = 0; cell < _shown.Length; cell++) _starts[cell + 1] = _starts[cell] + _shown[cell];
        Array.Clear(_shown);
        for (var place = 0; place < places.Length; place++)
        {
            var cell = IndexOf(places[place]);
            var entry = _starts[cell] + _shown[cell]++;
            _entries[entry] = new PlaceEntry(places[place], place);
            _entryOf[place] = entry;
        }
    }

    private bool IsEven()
    {
        var pairs = 0.0;
        foreach (var count in _shown) pairs += (double)count * count;
        return pairs <= MaxInCell * _entries.Length;
    }

    /// <summary>The cells whose farther distance from a cell, in columns or in rows, is <paramref name="ring"/>.</summary>
    private void TestRing(int column, int row, int ring, Point2D from, int except, ref NearestPlace best)
    {
        var (left, right) = (Math.Max(0, column - ring), Math.Min(_columns - 1, column + ring));
        for (var y = Math.Max(0, row - ring); y <= Math.Min(_rows - 1, row + ring); y++)
        {
            var isWhole = y == row - ring || y == row + ring;
            if (isWhole)
            {
                for (var x = left; x <= right; x++) TestCell((y * _columns) + x, from, except, ref best);
                continue;
            }

            if (column - ring >= 0) TestCell((y * _columns) + column - ring, from, except, ref best);
            if (column + ring < _columns) TestCell((y * _columns) + column + ring, from, except, ref best);
        }
    }

    private void TestCell(int cell, Point2D from, int except, ref NearestPlace best)
    {
        foreach (ref readonly var entry in _entries.AsSpan(_starts[cell], _shown[cell]))
        {
            var (x, y) = (entry.At.X - from.X, entry.At.Y - from.Y);
            if ((x * x) + (y * y) > best.Squared || entry.Place == except) continue;
            best.Offer(entry.Place, entry.At.DistanceTo(from));
        }
    }

    /// <summary>Lower bound of the distance of places outside the rings.</summary>
    private double Beyond(int column, int row, int ring, Point2D from)
    {
        var beyond = double.PositiveInfinity;
        if (column - ring > 0) beyond = Math.Min(beyond, from.X - (_bounds.MinX + ((column - ring) * _cell)));
        if (column + ring < _columns - 1) beyond = Math.Min(beyond, _bounds.MinX + ((column + ring + 1) * _cell) - from.X);
        if (row - ring > 0) beyond = Math.Min(beyond, from.Y - (_bounds.MinY + ((row - ring) * _cell)));
        if (row + ring < _rows - 1) beyond = Math.Min(beyond, _bounds.MinY + ((row + ring + 1) * _cell) - from.Y);
        return beyond - _margin - (Rounding * (Math.Abs(from.X) + Math.Abs(from.Y)));
    }

    private void Swap(int one, int other)
    {
        (_entries[one], _entries[other]) = (_entries[other], _entries[one]);
        _entryOf[_entries[one].Place] = one;
        _entryOf[_entries[other].Place] = other;
    }

    private (int Column, int Row) CellOf(Point2D place) => (Clamped((place.X - _bounds.MinX) / _cell, _columns), Clamped((place.Y - _bounds.MinY) / _cell, _rows));

    private int IndexOf(Point2D place)
    {
        var (column, row) = CellOf(place);
        return (row * _columns) + column;
    }

    /// <summary>Squares of one size.</summary>
    /// <param name="Shown">Number of shown places in each square, row by row.</param>
    /// <param name="Side">Side length, millimetres.</param>
    private sealed record Level(int[] Shown, int Columns, int Rows, double Side);

    private readonly record struct PlaceEntry(Point2D At, int Place);

    private struct NearestPlace(double within)
    {
        public int Place { get; private set; } = -1;

        public double Distance { get; private set; } = within;

        /// <summary>Slightly more than the square of the distance, so that equally near places are included.</summary>
        public double Squared { get; private set; } = SquareOf(within);

        private static double SquareOf(double distance) => distance * distance * (1.0 + Rounding);

        public void Offer(int place, double distance)
        {
            if (distance > Distance || (distance == Distance && Place >= 0 && place > Place)) return;
            (Place, Distance, Squared) = (place, distance, SquareOf(distance));
        }
    }
}
