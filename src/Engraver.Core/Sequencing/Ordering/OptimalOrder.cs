using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering.Optimising;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Improves the order of the nearest strokes: another order, other starts, other directions, with less travel. Every constraint that the order
/// complies with remains.</summary>
/// <param name="contours">Contours in order of their lowest row.</param>
/// <param name="segments">Rows of the contours by index.</param>
/// <param name="inside">The contour directly around each one, -1 for none.</param>
/// <param name="depth">Constraints of depth.</param>
/// <param name="search">Cost and extent.</param>
internal sealed class OptimalOrder(IReadOnlyList<Contour> contours, ReadOnlyMemory<Segment> segments, int[] inside, DepthOrder depth, OrderSearch search)
{
    /// <summary>The improved order.</summary>
    /// <param name="nearest">The order to improve.</param>
    /// <param name="first">The contour that must come first, after the contours inside it; its entry remains. Null for no requirement.</param>
    /// <param name="toolStart">Position of the tool at the start, mm.</param>
    /// <param name="toolEnd">Position that it moves to after the last stroke; null: it stays there.</param>
    public IReadOnlyList<StrokeEntry> Of(IReadOnlyList<StrokeEntry> nearest, int? first, Point2D toolStart, Point2D? toolEnd)
    {
        if (!OrderSteps.AreSearched(search, nearest.Count)) return nearest;
        var pinned = 0;
        while (pinned < nearest.Count && nearest[pinned].Contour != first) pinned++;
        if (pinned == nearest.Count) return Improved([.. nearest], toolStart, toolEnd);
        var entered = nearest[pinned];
        var left = TravelOrder.EndOf(entered, contours[entered.Contour], segments.Span);
        return [.. Improved([.. nearest.Take(pinned)], toolStart, entered.Place), entered, .. Improved([.. nearest.Skip(pinned + 1)], left, toolEnd)];
    }

    /// <summary>Improves the order of places, such as holes, that are visited.</summary>
    /// <param name="order">Numbers of the places in the order to improve.</param>
    /// <param name="options">Start and end of the tool, and the search.</param>
    public static IReadOnlyList<int> OfPlaces(Point2D[] places, IReadOnlyList<int> order, SequencingOptions options)
    {
        if (order.Count == 0 || !OrderSteps.AreSearched(options.Search, order.Count)) return order;
        var problem = new OrderProblem(options.ToolStart, options.ToolEnd);
        foreach (var place in order) problem.Add(NodeKind.Closed, [places[place]], 0);
        return [.. OrderOptimiser.Find(problem, options.Search).Select(one => order[one.Node - 1])];
    }

    private IReadOnlyList<StrokeEntry> Improved(StrokeEntry[] order, Point2D start, Point2D? end)
    {
        if (order.Length == 0) return order;
        var starts = new NodeStarts[order.Length];
        var problem = new OrderProblem(start, end);
        for (var i = 0; i < order.Length; i++)
        {
            starts[i] = NodeStarts.Of(order[i], contours[order[i].Contour], segments.Span);
            problem.Add(KindOf(order[i]), starts[i].Places, starts[i].First);
        }

        Require(problem, order);
        var found = OrderOptimiser.Find(problem, search);
        return [.. found.Select(one => starts[one.Node - 1].Entry(one.Entry, contours[order[one.Node - 1].Contour], segments.Span))];
    }

    private NodeKind KindOf(StrokeEntry entry)
    {
        if (contours[entry.Contour].Closed) return NodeKind.Closed;
        return depth.CanStart(entry.Contour, isTurned: false) && depth.CanStart(entry.Contour, isTurned: true) ? NodeKind.Open : NodeKind.Directed;
    }

    /// <summary>Nesting and depth. Contours that wait for each other cannot all comply; a requirement that the order breaks is left out.</summary>
    private void Require(OrderProblem problem, StrokeEntry[] order)
    {
        var nodes = new Dictionary<int, int>(order.Length);
        for (var i = 0; i < order.Length; i++) nodes[order[i].Contour] = i + 1;
        void Require(int before, int after)
        {
            if (nodes.TryGetValue(before, out var first) && nodes.TryGetValue(after, out var second) && first < second) problem.Require(first, second);
        }

        foreach (var entry in order)
        {
            if (inside[entry.Contour] >= 0) Require(entry.Contour, inside[entry.Contour]);
        }

        foreach (var (upper, lower) in depth.UpperLowerPairs) Require(upper, lower);
    }
}
