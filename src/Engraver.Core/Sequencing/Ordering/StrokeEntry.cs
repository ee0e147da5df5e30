using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>One possible start of a contour: at the start of one of its pieces, at its far end (reversed), or at a place of a circle.</summary>
/// <param name="Contour">Index of the contour.</param>
/// <param name="Piece">The piece that is cut first.</param>
/// <param name="Kind">Kind of start.</param>
/// <param name="Place">Start point of the cut, millimetres.</param>
public readonly record struct StrokeEntry(int Contour, int Piece, StrokeEntryKind Kind, Point2D Place)
{
    /// <summary>Number of possible starts of a contour: both ends of an open contour, each joint of a closed one, the right and left quadrant points of a
    /// circle.</summary>
    public static int CountOf(Contour contour, ReadOnlySpan<Segment> segments) => !contour.Closed || contour.IsCircleIn(segments) ? 2 : contour.Pieces.Length;

    /// <summary>One of the possible starts of a contour; 0 is the drawn one.</summary>
    public static StrokeEntry At(int number, int index, Contour contour, ReadOnlySpan<Segment> segments)
    {
        if (number == 0) return AsDrawn(index, contour, segments);
        if (!contour.Closed) return AtEnd(1, index, contour, contour.EndIn(segments));
        return contour.IsCircleIn(segments)
            ? LeftOf(index, segments[contour.Pieces.Span[0].Row].Arc)
            : new StrokeEntry(index, number, StrokeEntryKind.Forward, contour.Pieces.Span[number].StartIn(segments));
    }

    /// <summary>One of the two starts of an open contour, whose position is known.</summary>
    /// <param name="number">0 at its start, 1 at its end.</param>
    public static StrokeEntry AtEnd(int number, int index, Contour contour, Point2D place) => number == 0
        ? new StrokeEntry(index, 0, StrokeEntryKind.Forward, place)
        : new StrokeEntry(index, contour.Pieces.Length - 1, StrokeEntryKind.Turned, place);

    /// <summary>Adds every possible start of a contour, the drawn one first.</summary>
    public static void AddAll(int index, Contour contour, ReadOnlySpan<Segment> segments, List<StrokeEntry> entries)
    {
        var count = CountOf(contour, segments);
        for (var number = 0; number < count; number++) entries.Add(At(number, index, contour, segments));
    }

    public static StrokeEntry AsDrawn(int index, Contour contour, ReadOnlySpan<Segment> segments) =>
        new(index, 0, StrokeEntryKind.Forward, contour.StartIn(segments));

    /// <summary>A circle started at its point nearest to a place; null for any other contour, and when all points are equally near.</summary>
    public static StrokeEntry? NearestTo(Point2D place, int index, Contour contour, ReadOnlySpan<Segment> segments)
    {
        if (!contour.Closed || !contour.IsCircleIn(segments)) return null;
        var circle = segments[contour.Pieces.Span[0].Row].Arc;
        var spoke = place - circle.Centre;
        return spoke.Length > 0.0 ? new StrokeEntry(index, 0, StrokeEntryKind.OnCircle, circle.Centre + (spoke * (circle.Radius / spoke.Length))) : null;
    }

    private static StrokeEntry LeftOf(int index, ArcSegment circle) =>
        new(index, 0, StrokeEntryKind.OnCircle, circle.Centre - new Vector2D(circle.Radius, 0.0));
}

/// <summary>Kinds of start.</summary>
public enum StrokeEntryKind : byte
{
    /// <summary>At the start of a piece, in the direction of the contour (circles: at the right quadrant point).</summary>
    Forward,

    /// <summary>At the end of an open contour, every piece reversed.</summary>
    Turned,

    /// <summary>At a place of a circle, in the drawn direction: the left quadrant point, or the point nearest to the operator's entry.</summary>
    OnCircle,
}
