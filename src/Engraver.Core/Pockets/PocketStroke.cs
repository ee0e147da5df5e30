using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>Moves without a lift between them. Links keep the whole tool inside the region and run through the cut area, except for the step to a neighbouring
/// pass farther than the radius.</summary>
/// <param name="Moves">Each end is at the next start.</param>
/// <param name="Region">Number of the region.</param>
/// <param name="IsFinish">True when it removes the allowance.</param>
public sealed record PocketStroke(IReadOnlyList<PocketMove> Moves, int Region, bool IsFinish)
{
    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;
}
