using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>What a pass is for.</summary>
public enum PassKind
{
    /// <summary>At the tool's radius (and the allowance) from the wall.</summary>
    Wall,

    /// <summary>Parallel to the wall, further in.</summary>
    Contour,

    /// <summary>Between two passes, where they leave a sliver: in a corner, or along the middle.</summary>
    Sliver,

    /// <summary>Straight, of a zigzag.</summary>
    Row,

    /// <summary>Along the wall, behind all others, taking off the allowance.</summary>
    Finish,
}

/// <summary>One pass of the tool's centre: lines, arcs and circles, end on start, with the pocket on the left of a closed one.</summary>
/// <param name="Segments">At least one.</param>
/// <param name="Closed">The last ends where the first begins.</param>
/// <param name="Kind">What it is for.</param>
/// <param name="Level">0 at the wall, counted inwards; of a row its number from one side.</param>
/// <param name="Region">Number of the region, from 0.</param>
public sealed record PocketPass(IReadOnlyList<Segment> Segments, bool Closed, PassKind Kind, int Level, int Region);

/// <summary>One move of the tool down in the work.</summary>
/// <param name="Segment">Line, arc (of a whole turn at most) of the tool's centre.</param>
/// <param name="IsLink">Leads from pass to pass; otherwise it is part of a pass.</param>
public readonly record struct PocketMove(Segment Segment, bool IsLink);

/// <summary>Moves without a lift between them. Links keep the whole tool inside the region and go through what is cut, but for the step to a neighbouring pass farther than the radius.</summary>
/// <param name="Moves">End on start.</param>
/// <param name="Region">Number of the region.</param>
/// <param name="IsFinish">Takes off the allowance.</param>
public sealed record PocketStroke(IReadOnlyList<PocketMove> Moves, int Region, bool IsFinish)
{
    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;
}

/// <summary>A piece of the pocket that the round tool cannot reach: a corner, or a neck that is too narrow.</summary>
/// <param name="Place">Its point farthest from what is reached, on the wall.</param>
/// <param name="Depth">Distance of that point from what is reached, mm.</param>
/// <param name="Area">mm2; null where it could not be walked round.</param>
public sealed record UnreachedPlace(Point2D Place, double Depth, double? Area);

/// <summary>A region that the tool does not fit into.</summary>
/// <param name="Place">Where it is widest.</param>
/// <param name="Width">Diameter of the largest circle in it, mm.</param>
public sealed record NarrowRegion(Point2D Place, double Width);

/// <summary>Passes, strokes, and what they reach. Areas in mm2 from the lines and arcs themselves.</summary>
public sealed record PocketResult
{
    public required IReadOnlyList<PocketPass> Passes { get; init; }

    public required IReadOnlyList<PocketStroke> Strokes { get; init; }

    /// <summary>Inside the closed contours.</summary>
    public required double DrawnArea { get; init; }

    /// <summary>What a round tool of this radius can take off without touching a wall.</summary>
    public required double ReachableArea { get; init; }

    /// <summary>What the passes take off: the union of what the tool sweeps.</summary>
    public required double CoveredArea { get; init; }

    public required IReadOnlyList<UnreachedPlace> Unreached { get; init; }

    /// <summary>Borders of what the passes leave standing although the tool could reach it; none, or the result is wrong.</summary>
    public required IReadOnlyList<Point2D> LeftStanding { get; init; }

    public required IReadOnlyList<NarrowRegion> TooNarrow { get; init; }

    /// <summary>Where an offset could not be closed; none, or the result is incomplete.</summary>
    public required IReadOnlyList<Point2D> Unresolved { get; init; }

    /// <summary>Largest difference between a pass's distance from the wall and the one it should have, mm.</summary>
    public required double MaxDeviation { get; init; }

    /// <summary>Open contours, which have no inside.</summary>
    public required int WithoutInside { get; init; }

    /// <summary>Regions in the drawing, those that are too narrow among them.</summary>
    public required int Regions { get; init; }

    /// <summary>The walls of each region, for entries that must stay inside.</summary>
    internal IReadOnlyList<IReadOnlyList<PathPiece[]>> Walls { get; init; } = [];

    /// <summary>Part of the reachable area that is covered, 0 to 1; null where the tool reaches nothing.</summary>
    public double? Coverage => ReachableArea > 0.0 ? CoveredArea / ReachableArea : null;

    /// <summary>What the tool could reach and the passes leave, never negative.</summary>
    public double UncoveredArea => Math.Max(0.0, ReachableArea - CoveredArea);

    public double UnreachableArea => DrawnArea - ReachableArea;
}
