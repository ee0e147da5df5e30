using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Sequencing.Ordering;

/// <summary>The least travel of all orders and entries, by trying them. Shares no code with the optimiser.</summary>
internal sealed class ExhaustiveOrder
{
    private readonly IReadOnlyList<RandomStrokes.Stroke> _strokes;
    private readonly Func<Point2D, Point2D, double> _cost;
    private readonly Point2D? _end;
    private readonly bool[] _isCut;
    private double _best = double.PositiveInfinity;

    private ExhaustiveOrder(IReadOnlyList<RandomStrokes.Stroke> strokes, Point2D? end, Func<Point2D, Point2D, double> cost) =>
        (_strokes, _end, _cost, _isCut) = (strokes, end, cost, new bool[strokes.Count]);

    public static double LeastCost(IReadOnlyList<RandomStrokes.Stroke> strokes, Point2D start, Point2D? end, Func<Point2D, Point2D, double> cost)
    {
        var search = new ExhaustiveOrder(strokes, end, cost);
        search.Continue(start, 0.0, strokes.Count);
        return search._best;
    }

    private void Continue(Point2D tool, double cost, int left)
    {
        if (left == 0) _best = Math.Min(_best, cost + (_end is { } end ? _cost(tool, end) : 0.0));
        for (var next = 0; next < _strokes.Count && cost < _best; next++)
        {
            if (_isCut[next] || Enumerable.Range(0, _strokes.Count).Any(inner => _strokes[inner].Around == next && !_isCut[inner])) continue;
            _isCut[next] = true;
            foreach (var (start, finish) in _strokes[next].Entries) Continue(finish, cost + _cost(tool, start), left - 1);
            _isCut[next] = false;
        }
    }
}
