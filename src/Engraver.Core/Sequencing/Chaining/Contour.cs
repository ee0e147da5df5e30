using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Segments joined end to start. An open contour starts at one of its ends, a closed contour at its lowest row; both run in the direction of their
/// lowest row.</summary>
/// <param name="Pieces">Pieces, at least one.</param>
/// <param name="Closed">True when the last piece ends within the join tolerance of the start of the first.</param>
public readonly record struct Contour(ReadOnlyMemory<ContourPiece> Pieces, bool Closed)
{
    public Point2D StartIn(ReadOnlySpan<Segment> segments) => Pieces.Span[0].StartIn(segments);

    public Point2D EndIn(ReadOnlySpan<Segment> segments) => Pieces.Span[^1].EndIn(segments);

    /// <summary>True for a full circle drawn as a circle: it can start at either quadrant point.</summary>
    public bool IsCircleIn(ReadOnlySpan<Segment> segments) => Pieces.Length == 1 && segments[Pieces.Span[0].Row].Kind == SegmentKind.Circle;
}
