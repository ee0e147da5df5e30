using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>One contour at its position in the order of cutting, with its direction and start point.</summary>
/// <param name="Index">0 is cut first.</param>
/// <param name="Closed">True when it ends where it starts (within the join tolerance).</param>
/// <param name="Moves">Segments in order and direction, read from the sequenced table.</param>
/// <param name="Segments">Lines, arcs, circles, ellipses and splines in it, each counted as one.</param>
/// <param name="Length">Length along the path, millimetres.</param>
/// <param name="Inside">Index of the closed stroke that directly encloses this one, -1 for none; always greater than <paramref name="Index"/>.</param>
public sealed record SequencedStroke(int Index, bool Closed, IReadOnlyList<StrokeMove> Moves, int Segments, double Length, int Inside)
{
    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;
}
