using Engraver.Benchmarks.Stages;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Ordering;

/// <summary>Slow search for the least travel by simulated annealing: single random changes of an array, without lists of improvements. Shares no code with the
/// optimiser.</summary>
internal sealed class ReferenceSolver
{
    private const int NearCount = 12;
    private const int MaxRange = 1000;

    /// <summary>The temperature decreases from the first to the second, in mean links of the first order.</summary>
    private const double Hot = 1.0;
    private const double Cold = 0.003;

    private readonly IReadOnlyList<OrderShape> _shapes;
    private readonly Point2D[][] _starts;
    private readonly int[][] _near;
    private readonly List<int>[] _inner;
    private readonly int[] _order;
    private readonly int[] _places;
    private readonly int[] _entries;
    private readonly SeededSequence _random;

    /// <param name="order">Shapes in an order in which inner ones come first.</param>
    public ReferenceSolver(OrderInstance instance, IReadOnlyList<int> order, ulong seed)
    {
        (_shapes, _random) = (instance.Shapes, new SeededSequence(seed));
        _starts = [.. _shapes.Select(StartsOf)];
        (_order, _places, _entries) = ([.. order], new int[order.Count], new int[order.Count]);
        for (var place = 0; place < _order.Length; place++) _places[_order[place]] = place;
        _inner = [.. _shapes.Select(_ => new List<int>())];
        for (var shape = 0; shape < _shapes.Count; shape++)
        {
            if (_shapes[shape].Around >= 0) _inner[_shapes[shape].Around].Add(shape);
        }

        _near = [.. Enumerable.Range(0, _shapes.Count).Select(NearOf)];
    }

    /// <summary>There and back, from and to the origin.</summary>
    public double Travel => Enumerable.Range(0, _order.Length + 1).Sum(place => Link(At(place - 1), At(place)));

    /// <summary>Runs once from hot to cold.</summary>
    /// <returns>The travel, mm.</returns>
    public double Run(long trials)
    {
        var scale = Travel / _order.Length;
        var temperature = Hot * scale;
        for (var trial = 0L; trial < trials; trial++)
        {
            if (trial % 1000 == 0) temperature = scale * Hot * Math.Pow(Cold / Hot, (double)trial / trials);
            var allowed = -temperature * Math.Log(1.0 - _random.Fraction());
            var shape = _random.Below(_order.Length);
            switch (_random.Below(4))
            {
                case 0: TryEntry(shape, allowed); break;
                case 1: TryReverse(shape, _near[shape][_random.Below(_near[shape].Length)], allowed); break;
                default: TryMove(shape, _near[shape][_random.Below(_near[shape].Length)], allowed); break;
            }
        }

        return Travel;
    }

    private static Point2D[] StartsOf(OrderShape shape) => shape.IsCircle
        ? [.. Enumerable.Range(0, 4).Select(quadrant => OrderShape.OnCircle(shape.Points[0], shape.Radius, Math.PI / 2.0 * quadrant))]
        : shape.IsClosed ? shape.Points : [shape.Points[0], shape.Points[^1]];

    private int[] NearOf(int shape) => [.. Enumerable.Range(0, _shapes.Count).Where(other => other != shape).OrderBy(other => _starts[shape].Min(place => _starts[other].Min(place.DistanceTo))).Take(NearCount)];

    private int At(int place) => place < 0 || place >= _order.Length ? -1 : _order[place];

    private Point2D StartOf(int shape) => shape < 0 ? default : _starts[shape][_entries[shape]];

    private Point2D EndOf(int shape) => shape < 0 ? default : _starts[shape][_shapes[shape].IsClosed ? _entries[shape] : 1 - _entries[shape]];

    private double Link(int from, int to) => EndOf(from).DistanceTo(StartOf(to));

    private void TryEntry(int shape, double allowed)
    {
        var (before, after, entry) = (At(_places[shape] - 1), At(_places[shape] + 1), _entries[shape]);
        var now = Link(before, shape) + Link(shape, after);
        _entries[shape] = _random.Below(_starts[shape].Length);
        if (Link(before, shape) + Link(shape, after) - now > allowed) _entries[shape] = entry;
    }

    /// <summary>Links a shape with a near one by reversing what is between them.</summary>
    private void TryReverse(int shape, int near, double allowed)
    {
        var (first, last) = _places[shape] < _places[near] ? (_places[shape] + 1, _places[near]) : (_places[near], _places[shape] - 1);
        if (last - first >= MaxRange || first >= last) return;
        var (before, after) = (At(first - 1), At(last + 1));
        var now = Link(before, _order[first]) + Link(_order[last], after);
        var then = EndOf(before).DistanceTo(EndOf(_order[last])) + StartOf(_order[first]).DistanceTo(StartOf(after));
        if (then - now > allowed) return;
        for (var place = first; place <= last; place++)
        {
            var around = _shapes[_order[place]].Around;
            if (around >= 0 && _places[around] <= last) return;
        }

        Array.Reverse(_order, first, last - first + 1);
        for (var place = first; place <= last; place++)
        {
            _places[_order[place]] = place;
            if (!_shapes[_order[place]].IsClosed) _entries[_order[place]] ^= 1;
        }
    }

    /// <summary>Moves a shape, with everything inside it that directly precedes it or alone, before or behind a near one.</summary>
    private void TryMove(int shape, int near, double allowed)
    {
        var last = _places[shape];
        var first = _random.Below(2) == 0 ? FirstOfBlock(shape) : last;
        var target = _places[near] + _random.Below(2); // the place before which the part is put
        if (target >= first && target <= last + 1) return;
        var (before, after, left, right) = (At(first - 1), At(last + 1), At(target - 1), At(target));
        var (head, entry) = (_order[first], _entries[shape]);
        var now = Link(before, head) + Link(shape, after) + Link(left, right);
        if (first == last) _entries[shape] = _random.Below(_starts[shape].Length);
        if (Link(before, after) + Link(left, head) + Link(shape, right) - now > allowed || !CanMove(first, last, target))
        {
            _entries[shape] = entry;
            return;
        }

        Rotate(first, last, target);
    }

    private int FirstOfBlock(int shape)
    {
        var first = _places[shape];
        while (first > 0 && IsWithin(_order[first - 1], shape)) first--;
        return first;
    }

    private bool IsWithin(int inner, int outer)
    {
        while (inner >= 0 && inner != outer) inner = _shapes[inner].Around;
        return inner == outer;
    }

    private bool CanMove(int first, int last, int target)
    {
        if (Math.Abs(target - first) > MaxRange) return false;
        for (var place = first; place <= last; place++)
        {
            var shape = _order[place];
            if (target > last && _shapes[shape].Around is >= 0 and var around && _places[around] > last && _places[around] < target) return false;
            if (target < first && _inner[shape].Exists(inner => _places[inner] >= target && _places[inner] < first)) return false;
        }

        return true;
    }

    private void Rotate(int first, int last, int target)
    {
        var part = _order[first..(last + 1)];
        if (target > last) Array.Copy(_order, last + 1, _order, first, target - last - 1);
        else Array.Copy(_order, target, _order, target + part.Length, first - target);
        part.CopyTo(_order, target > last ? target - part.Length : target);
        for (var place = Math.Min(first, target); place < Math.Max(last + 1, target); place++) _places[_order[place]] = place;
    }
}
