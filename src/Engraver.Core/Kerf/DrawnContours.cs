using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Kerf;

/// <summary>The contours of a chained table, ready to be offset.</summary>
public static class DrawnContours
{
    /// <summary>All contours in their order and direction; their segments are in the order of the contours' pieces.</summary>
    public static IReadOnlyList<OffsetContour> From(ChainedTable chained)
    {
        ArgumentNullException.ThrowIfNull(chained);
        var segments = chained.Segments;
        return [.. chained.Chain.Contours.Select(contour => new OffsetContour(SegmentsOf(contour, segments.Span), contour.Closed))];
    }

    private static Segment[] SegmentsOf(Contour contour, ReadOnlySpan<Segment> rows)
    {
        var segments = new Segment[contour.Pieces.Length];
        for (var i = 0; i < segments.Length; i++)
        {
            var piece = contour.Pieces.Span[i];
            segments[i] = piece.Reversed ? rows[piece.Row].Reversed() : rows[piece.Row];
        }

        return segments;
    }
}
