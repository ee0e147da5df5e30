using Engraver.Core.Geometry;

namespace Engraver.Core.Toolpaths;

/// <summary>One contour as it will be cut: moves that follow each other, tool down from the first to the last.</summary>
/// <param name="Index">Place in the order of cutting, 0 is first.</param>
/// <param name="Closed">True when the stroke ends where it starts.</param>
/// <param name="Moves">At least one move; each starts within the join tolerance of the end of the one before.</param>
public sealed record ToolpathStroke(int Index, bool Closed, IReadOnlyList<ToolpathMove> Moves)
{
    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;

    public double Length => Moves.Sum(move => move.Segment.Length);
}
