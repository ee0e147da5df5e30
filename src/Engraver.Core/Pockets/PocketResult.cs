using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>One move of the tool at depth in the work.</summary>
/// <param name="Segment">Line or arc (at most a full turn) of the tool's centre.</param>
/// <param name="IsLink">True when it leads from pass to pass; otherwise it is part of a pass.</param>
public readonly record struct PocketMove(Segment Segment, bool IsLink);

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
