using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>The starts of one contour between which the optimal order chooses: both ends of an open contour, the joints of a closed one, the four quadrant
/// points of a circle, and the start that it has already.</summary>
/// <param name="Index">Index of the contour.</param>
/// <param name="Places">Positions, millimetres.</param>
/// <param name="Numbers">The piece or the quadrant of each; the pieces of a contour of many pieces are a sample.</param>
/// <param name="First">Number of the present start among them.</param>
internal readonly record struct NodeStarts(int Index, Point2D[] Places, int[] Numbers, int First)
{
    private const int MaxPlaces = 48;
    private const int Quadrants = 4;

    public static NodeStarts Of(StrokeEntry present, Contour contour, ReadOnlySpan<Segment> segments)
    {
        if (!contour.Closed) return new NodeStarts(present.Contour, [contour.StartIn(segments), contour.EndIn(segments)], [0, 1], present.Kind == StrokeEntryKind.Turned ? 1 : 0);
        return contour.IsCircleIn(segments) ? OfCircle(present, segments[contour.Pieces.Span[0].Row].Arc) : OfClosed(present, contour, segments);
    }

    /// <summary>One of the starts.</summary>
    public StrokeEntry Entry(int number, Contour contour, ReadOnlySpan<Segment> segments)
    {
        if (!contour.Closed) return StrokeEntry.AtEnd(number, Index, contour, Places[number]);
        if (!contour.IsCircleIn(segments)) return new StrokeEntry(Index, Numbers[number], StrokeEntryKind.Forward, Places[number]);
        return number == 0 ? StrokeEntry.AsDrawn(Index, contour, segments) : new StrokeEntry(Index, 0, StrokeEntryKind.OnCircle, Places[number]);
    }

    /// <summary>The nearest order starts a circle at its right or left quadrant point.</summary>
    private static NodeStarts OfCircle(StrokeEntry present, ArcSegment circle)
    {
        var (centre, radius) = (circle.Centre, circle.Radius);
        Point2D[] places = [centre + new Vector2D(radius, 0.0), centre + new Vector2D(0.0, radius), centre - new Vector2D(radius, 0.0), centre - new Vector2D(0.0, radius)];
        return new NodeStarts(present.Contour, places, [.. Enumerable.Range(0, Quadrants)], present.Kind == StrokeEntryKind.OnCircle ? 2 : 0);
    }

    private static NodeStarts OfClosed(StrokeEntry present, Contour contour, ReadOnlySpan<Segment> segments)
    {
        var pieces = contour.Pieces.Span;
        var step = (pieces.Length + MaxPlaces - 1) / MaxPlaces;
        var numbers = new List<int>();
        for (var piece = present.Piece % step; piece < pieces.Length; piece += step) numbers.Add(piece);
        var places = new Point2D[numbers.Count];
        for (var i = 0; i < places.Length; i++) places[i] = pieces[numbers[i]].StartIn(segments);
        return new NodeStarts(present.Contour, places, [.. numbers], present.Piece / step);
    }
}
