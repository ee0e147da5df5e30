namespace Engraver.Core.Geometry;

/// <summary>Boxes sorted along a Hilbert curve under a tree of boxes with four children per node: nearest and overlap queries in logarithmic time, however
/// unevenly the drawing is distributed.</summary>
/// <remarks>Items can be hidden and shown again, for example strokes that have been cut. Not safe for use from several threads while items are hidden or
/// shown.</remarks>
public sealed class BoxTree
{
    private const int Fanout = 4;
    private const int NoItem = int.MaxValue;
    private readonly int[] _items;
    private readonly int[] _slotOfItem;
    private readonly Bounds2D[][] _boxes;

    /// <summary>For each box the lowest number of a shown item in it; <see cref="NoItem"/> when there is none.</summary>
    private readonly int[][] _lowest;

    private BoxTree(int[] items, Bounds2D[] leaves)
    {
        _items = items;
        _slotOfItem = new int[items.Length];
        for (var slot = 0; slot < items.Length; slot++) _slotOfItem[items[slot]] = slot;
        var boxes = new List<Bounds2D[]> { leaves };
        List<int[]> lowest = [[.. items]];
        while (boxes[^1].Length > 1) AddLevel(boxes, lowest);
        _boxes = [.. boxes];
        _lowest = [.. lowest];
    }

    /// <summary>Distance of item <paramref name="item"/> from <paramref name="place"/>. Several items may be pieces of one object and all return the distance
    /// of the whole; each piece must then be in its box.</summary>
    public delegate double Measure(int item, Point2D place);

    /// <summary>All items, hidden ones too, along the Hilbert curve: successive queries in this order go through the same boxes, which are then still in the
    /// processor's cache.</summary>
    public ReadOnlySpan<int> AlongCurve => _items;

    /// <summary>A tree over boxes; item numbers are indices into <paramref name="boxes"/>.</summary>
    public static BoxTree Build(ReadOnlySpan<Bounds2D> boxes)
    {
        var keys = HilbertCurve.KeysOf(boxes);
        var items = new int[boxes.Length];
        for (var i = 0; i < items.Length; i++) items[i] = i;
        Array.Sort(keys, items);
        var leaves = new Bounds2D[boxes.Length];
        for (var slot = 0; slot < leaves.Length; slot++) leaves[slot] = boxes[items[slot]];
        return new BoxTree(items, leaves);
    }

    public static BoxTree Build(ReadOnlySpan<Point2D> places)
    {
        var boxes = new Bounds2D[places.Length];
        for (var i = 0; i < boxes.Length; i++) boxes[i] = Bounds2D.FromCorners(places[i], places[i]);
        return Build(boxes);
    }

    /// <summary>Excludes an item from every result until it is shown again. Hiding it twice has no further effect.</summary>
    public void Hide(int item) => Set(item, NoItem);

    public void Show(int item) => Set(item, item);

    /// <summary>The nearest shown item by <paramref name="measure"/>, ties to the lower number; -1 when none is nearer than or as near as
    /// <paramref name="within"/>.</summary>
    /// <param name="place">Point to measure from.</param>
    /// <param name="measure">Exact distance of an item.</param>
    /// <param name="within">Largest distance of interest; positive infinity for any.</param>
    /// <param name="distance">Distance of the result, or <paramref name="within"/> when there is none.</param>
    public int Nearest(Point2D place, Measure measure, double within, out double distance)
    {
        var best = new NearestItem(-1, within);
        if (_items.Length > 0 && _lowest[^1][0] != NoItem) Descend(_boxes.Length - 1, 0, place, measure, ref best);
        distance = best.Distance;
        return best.Item;
    }

    /// <summary>Adds every shown item whose box overlaps (or touches) <paramref name="box"/> to <paramref name="found"/>, in no particular order.</summary>
    public void Overlapping(Bounds2D box, List<int> found)
    {
        if (_items.Length > 0) Collect(_boxes.Length - 1, 0, box, isAround: false, found);
    }

    /// <summary>Adds every shown item whose box contains <paramref name="box"/> to <paramref name="found"/>, in no particular order.</summary>
    public void Containing(Bounds2D box, List<int> found)
    {
        if (_items.Length > 0) Collect(_boxes.Length - 1, 0, box, isAround: true, found);
    }

    private static void AddLevel(List<Bounds2D[]> boxes, List<int[]> lowest)
    {
        var (below, numbers) = (boxes[^1], lowest[^1]);
        var size = (below.Length + Fanout - 1) / Fanout;
        var unions = new Bounds2D[size];
        var minima = new int[size];
        Array.Fill(unions, Bounds2D.Empty);
        Array.Fill(minima, NoItem);
        for (var i = 0; i < below.Length; i++)
        {
            unions[i / Fanout] = unions[i / Fanout].Union(below[i]);
            minima[i / Fanout] = Math.Min(minima[i / Fanout], numbers[i]);
        }

        boxes.Add(unions);
        lowest.Add(minima);
    }

    private static double Distance(in Bounds2D box, Point2D place)
    {
        var x = Math.Max(0.0, Math.Max(box.MinX - place.X, place.X - box.MaxX));
        var y = Math.Max(0.0, Math.Max(box.MinY - place.Y, place.Y - box.MaxY));
        return x == 0.0 ? y : y == 0.0 ? x : double.Hypot(x, y); // rounded as Point2D.DistanceTo, so that the box of a single point has exactly that point's distance
    }

    private static bool Overlap(in Bounds2D a, in Bounds2D b) => a.MinX <= b.MaxX && b.MinX <= a.MaxX && a.MinY <= b.MaxY && b.MinY <= a.MaxY;

    private void Set(int item, int number)
    {
        var index = _slotOfItem[item];
        for (var level = 0; level < _lowest.Length && _lowest[level][index] != number; level++)
        {
            _lowest[level][index] = number;
            index /= Fanout;
            number = Lowest(_lowest[level].AsSpan(index * Fanout, Math.Min(Fanout, _lowest[level].Length - (index * Fanout))));
        }
    }

    private static int Lowest(ReadOnlySpan<int> numbers)
    {
        var lowest = NoItem;
        foreach (var number in numbers) lowest = Math.Min(lowest, number);
        return lowest;
    }

    private void Descend(int level, int index, Point2D place, Measure measure, ref NearestItem best)
    {
        if (level == 0)
        {
            best.Offer(_items[index], measure(_items[index], place));
            return;
        }

        var first = index * Fanout;
        var count = Math.Min(Fanout, _boxes[level - 1].Length - first);
        Span<double> distances = stackalloc double[Fanout];
        for (var i = 0; i < count; i++)
        {
            distances[i] = _lowest[level - 1][first + i] == NoItem ? double.PositiveInfinity : Distance(_boxes[level - 1][first + i], place);
        }

        for (var visit = 0; visit < count; visit++)
        {
            var nearest = IndexOfSmallest(distances[..count], _lowest[level - 1].AsSpan(first, count));
            if (double.IsPositiveInfinity(distances[nearest]) || best.Beats(distances[nearest], _lowest[level - 1][first + nearest])) return;
            distances[nearest] = double.PositiveInfinity;
            Descend(level - 1, first + nearest, place, measure, ref best);
        }
    }

    /// <summary>Index of the smallest value; among equal values of the one with the lowest number, so that other boxes at that distance need not be
    /// searched.</summary>
    private static int IndexOfSmallest(ReadOnlySpan<double> values, ReadOnlySpan<int> numbers)
    {
        var smallest = 0;
        for (var i = 1; i < values.Length; i++)
        {
            if (values[i] < values[smallest] || (values[i] == values[smallest] && numbers[i] < numbers[smallest])) smallest = i;
        }

        return smallest;
    }

    /// <param name="isAround">True for the items whose box contains the box, false for those whose box overlaps it.</param>
    private void Collect(int level, int index, in Bounds2D box, bool isAround, List<int> found)
    {
        if (_lowest[level][index] == NoItem || !(isAround ? _boxes[level][index].Contains(box) : Overlap(_boxes[level][index], box))) return;
        if (level == 0)
        {
            found.Add(_items[index]);
            return;
        }

        var end = Math.Min((index + 1) * Fanout, _boxes[level - 1].Length);
        for (var child = index * Fanout; child < end; child++) Collect(level - 1, child, box, isAround, found);
    }

    internal struct NearestItem(int item, double distance)
    {
        public int Item { get; private set; } = item;

        public double Distance { get; private set; } = distance;

        /// <summary>True when an item at this distance, with a number that is not lower, is not better.</summary>
        public readonly bool Beats(double distance, int item) => distance > Distance || (distance == Distance && Item >= 0 && item >= Item);

        public void Offer(int item, double distance)
        {
            if (Beats(distance, item)) return;
            Item = item;
            Distance = distance;
        }
    }
}
