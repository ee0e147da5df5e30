using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Segments joined end to start. An open contour begins at one of its ends, a closed one at its lowest row; both run in the direction of their lowest row.</summary>
/// <param name="Pieces">At least one.</param>
/// <param name="Closed">True when the last piece ends within the join tolerance of the start of the first.</param>
public sealed record Contour(ReadOnlyMemory<ContourPiece> Pieces, bool Closed)
{
    public Point2D StartIn(ReadOnlySpan<Segment> segments) => Pieces.Span[0].StartIn(segments);

    public Point2D EndIn(ReadOnlySpan<Segment> segments) => Pieces.Span[^1].EndIn(segments);

    /// <summary>True for a whole circle drawn as one: it can start at either quadrant point.</summary>
    public bool IsCircleIn(ReadOnlySpan<Segment> segments) => Pieces.Length == 1 && segments[Pieces.Span[0].Row].Kind == SegmentKind.Circle;
}
