using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Purpose of a pass.</summary>
public enum PassKind
{
    /// <summary>At the tool's radius (and the allowance) from the wall.</summary>
    Wall,

    /// <summary>Parallel to the wall, further in.</summary>
    Contour,

    /// <summary>Between two passes that leave a sliver: in a corner, or along the middle.</summary>
    Sliver,

    /// <summary>A straight row of a zigzag.</summary>
    Row,

    /// <summary>Along the wall, after all other passes, removing the allowance.</summary>
    Finish,
}

/// <summary>One pass of the tool's centre: lines, arcs and circles, each end at the next start, with the pocket on the left of a closed pass.</summary>
/// <param name="Segments">Segments, at least one.</param>
/// <param name="Closed">True when the last segment ends where the first starts.</param>
/// <param name="Kind">Purpose of the pass.</param>
/// <param name="Level">0 at the wall, counted inwards; for a row its number from one side.</param>
/// <param name="Region">Number of the region, from 0.</param>
public sealed record PocketPass(IReadOnlyList<Segment> Segments, bool Closed, PassKind Kind, int Level, int Region);

/// <summary>One move of the tool at depth in the work.</summary>
/// <param name="Segment">Line or arc (at most a full turn) of the tool's centre.</param>
/// <param name="IsLink">True when it leads from pass to pass; otherwise it is part of a pass.</param>
public readonly record struct PocketMove(Segment Segment, bool IsLink);

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

/// <summary>A piece of the pocket that the round tool cannot reach: a corner, or a neck that is too narrow.</summary>
/// <param name="Place">The point of the piece on the wall that is farthest from the reached area.</param>
/// <param name="Depth">Distance of that point from the reached area, mm.</param>
/// <param name="Area">Area, mm2; null when its boundary could not be closed.</param>
public sealed record UnreachedPlace(Point2D Place, double Depth, double? Area);

/// <summary>A region that is too narrow for the tool.</summary>
/// <param name="Place">The widest point of the region.</param>
/// <param name="Width">Diameter of the largest circle in it, mm.</param>
public sealed record NarrowRegion(Point2D Place, double Width);

/// <summary>Passes, strokes, and the area that they reach. Areas in mm2 from the lines and arcs themselves.</summary>
public sealed record PocketResult
{
    public required IReadOnlyList<PocketPass> Passes { get; init; }

    public required IReadOnlyList<PocketStroke> Strokes { get; init; }

    /// <summary>Area inside the closed contours.</summary>
    public required double DrawnArea { get; init; }

    /// <summary>Area that a round tool of this radius can clear without touching a wall.</summary>
    public required double ReachableArea { get; init; }

    /// <summary>Area that the passes clear: the union of the areas that the tool sweeps.</summary>
    public required double CoveredArea { get; init; }

    public required IReadOnlyList<UnreachedPlace> Unreached { get; init; }

    /// <summary>Boundaries of the areas that the passes leave although the tool could reach them; must be empty for a correct result.</summary>
    public required IReadOnlyList<Point2D> LeftStanding { get; init; }

    public required IReadOnlyList<NarrowRegion> TooNarrow { get; init; }

    /// <summary>Points where an offset could not be closed; must be empty for a complete result.</summary>
    public required IReadOnlyList<Point2D> Unresolved { get; init; }

    /// <summary>Largest difference between the actual and the required distance of a pass from the wall, mm.</summary>
    public required double MaxDeviation { get; init; }

    /// <summary>Number of open contours, which have no inside.</summary>
    public required int WithoutInside { get; init; }

    /// <summary>Number of regions in the drawing, including those that are too narrow.</summary>
    public required int Regions { get; init; }

    /// <summary>The walls of each region, for entries that must stay inside.</summary>
    internal IReadOnlyList<IReadOnlyList<PathPiece[]>> Walls { get; init; } = [];

    /// <summary>Fraction of the reachable area that is covered, 0 to 1; null when the tool reaches no area.</summary>
    public double? Coverage => ReachableArea > 0.0 ? CoveredArea / ReachableArea : null;

    /// <summary>Area that the tool could reach but the passes leave, never negative.</summary>
    public double UncoveredArea => Math.Max(0.0, ReachableArea - CoveredArea);

    public double UnreachableArea => DrawnArea - ReachableArea;
}
