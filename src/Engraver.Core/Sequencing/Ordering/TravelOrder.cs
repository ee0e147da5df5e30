using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Decides the order of contours as strokes, and the start of each. Inner contours always come before the enclosing contour.</summary>
public static class TravelOrder
{
    /// <summary>File order: each contour as drawn, in the order of their lowest rows; a contour that encloses others waits for them and then follows
    /// directly.</summary>
    /// <param name="contours">Contours in order of their lowest row.</param>
    /// <param name="segments">Rows of the contours by index.</param>
    /// <param name="inside">The contour directly around each one, -1 for none (see <see cref="ContourNesting"/>).</param>
    /// <param name="toolStart">Position of the tool at the start: a circle starts at its left or right quadrant point, whichever is nearer to the tool (paper
    /// 001, section 4.1; tie: right).</param>
    /// <param name="first">The entry of the contour that must come first (after the contours inside it); null for no requirement.</param>
    public static IReadOnlyList<StrokeEntry> Drawn(
        IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, ReadOnlySpan<int> inside, Point2D toolStart, StrokeEntry? first)
    {
        var order = new List<StrokeEntry>(contours.Count);
        var tool = toolStart;
        foreach (var contour in InnerFirst(inside, first?.Contour))
        {
            order.Add(first is { } entry && entry.Contour == contour ? entry : DrawnEntry(contour, contours[contour], segments, tool));
            tool = EndOf(order[^1], contours[contour], segments);
        }

        return order;
    }

    /// <summary>Nearest first: from the tool's position to the nearest start of any contour that may be cut, in case of a tie the lower contour and its drawn
    /// start.</summary>
    /// <remarks>Open contours are entered from either end, closed ones at the nearest joint, circles at the nearer of two quadrant points. Logarithmic per
    /// step.</remarks>
    /// <param name="contours">Contours in order of their lowest row.</param>
    /// <param name="segments">Rows of the contours by index.</param>
    /// <param name="inside">The contour directly around each one, -1 for none.</param>
    /// <param name="depth">Constraints of depth: the contours that wait for contours above them, and the allowed entries.</param>
    /// <param name="toolStart">Position of the tool at the start.</param>
    /// <param name="first">The entry of the contour that must come first (after the contours inside it); null for no requirement.</param>
    internal static IReadOnlyList<StrokeEntry> Nearest(
        IReadOnlyList<Contour> contours, ReadOnlyMemory<Segment> segments, ReadOnlySpan<int> inside, DepthOrder depth, Point2D toolStart, StrokeEntry? first)
    {
        var search = new NearestStartSearch(contours, segments, inside, depth);
        var order = new List<StrokeEntry>(contours.Count);
        var tool = toolStart;
        if (first is { } entered)
        {
            search.RestrictTo(entered.Contour);
            while (search.Next(tool) is { } inner) tool = Take(inner);
            tool = Take(entered);
            search.Unrestrict();
        }

        while (search.Next(tool) is { } next) tool = Take(next);
        return order;

        Point2D Take(StrokeEntry entry)
        {
            order.Add(entry);
            search.Done(entry.Contour);
            return search.EndOf(entry);
        }
    }

    /// <summary>Position of the tool after a contour with this entry.</summary>
    internal static Point2D EndOf(StrokeEntry entry, Contour contour, ReadOnlySpan<Segment> segments) => entry.Kind switch
    {
        StrokeEntryKind.OnCircle => entry.Place,
        StrokeEntryKind.Turned => contour.StartIn(segments),
        _ when entry.Piece > 0 => contour.Pieces.Span[entry.Piece - 1].EndIn(segments),
        _ => contour.EndIn(segments),
    };

    private static StrokeEntry DrawnEntry(int index, Contour contour, ReadOnlySpan<Segment> segments, Point2D tool)
    {
        if (!contour.IsCircleIn(segments)) return StrokeEntry.AsDrawn(index, contour, segments);
        var entries = new List<StrokeEntry>();
        StrokeEntry.AddAll(index, contour, segments, entries);
        return entries.MinBy(entry => entry.Place.DistanceTo(tool));
    }

    /// <summary>Contours in index order, each after all contours inside it; <paramref name="first"/> with its inside comes first. Uses an explicit stack,
    /// because drawings can nest deeper than a thread's stack.</summary>
    private static List<int> InnerFirst(ReadOnlySpan<int> inside, int? first)
    {
        var children = new List<int>?[inside.Length];
        var waiting = new Stack<(int Contour, bool ChildrenDone)>();
        var order = new List<int>(inside.Length);
        for (var i = inside.Length - 1; i >= 0; i--)
        {
            if (i == first) continue;
            if (inside[i] < 0) waiting.Push((i, false));
            else (children[inside[i]] ??= []).Add(i);
        }

        if (first is { } entered) waiting.Push((entered, false));
        while (waiting.TryPop(out var next))
        {
            if (next.ChildrenDone || children[next.Contour] is not { } inner)
            {
                order.Add(next.Contour);
                continue;
            }

            waiting.Push((next.Contour, true));
            foreach (var child in inner) waiting.Push((child, false));
        }

        return order;
    }
}
