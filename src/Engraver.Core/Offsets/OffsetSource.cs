namespace Engraver.Core.Offsets;

/// <summary>Source of a segment of an offset.</summary>
/// <param name="Contour">Number of the contour among those that were offset.</param>
/// <param name="Segment">Number of the segment within it; for a join, the segment before the corner in the direction in which the contour was followed.</param>
/// <param name="IsJoin">True when it runs around the outside of a corner or around the end of an open contour.</param>
public readonly record struct OffsetSource(int Contour, int Segment, bool IsJoin);
