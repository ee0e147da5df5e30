using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The points of one uniform Catmull-Rom spline and its known properties, as run by a controller of the SACE bench or an XPS (paper 004).</summary>
public sealed record Trajectory
{
    /// <summary>Points as in the file, millimetres of the drawing, rounded to nine decimals: the phantom point that sets the start tangent, the visited points,
    /// and the phantom point of the end.</summary>
    public required IReadOnlyList<Point2D> Lines { get; init; }

    /// <summary>Height of the whole trajectory, millimetres; with <see cref="Heights"/>, the height of its start.</summary>
    public double Z { get; init; }

    /// <summary>For each of <see cref="Lines"/>, millimetres, when they differ (a helix); null when the whole trajectory is at <see cref="Z"/>.</summary>
    public IReadOnlyList<double>? Heights { get; init; }

    /// <summary>The lengths along the source of the visited points, millimetres, increasing; for a closed trajectory the last is the first plus the source
    /// length.</summary>
    public required IReadOnlyList<double> Knots { get; init; }

    /// <summary>The source: the segments of a contour from corner to corner, or all segments.</summary>
    public required IReadOnlyList<Segment> Source { get; init; }

    /// <summary>True when it ends where it starts without a corner there; the spline is then periodic.</summary>
    public required bool Closed { get; init; }

    /// <summary>Largest distance at dense samples, millimetres; for information only, never used as a criterion.</summary>
    public required double SampledError { get; init; }

    /// <summary>Proven bound (<see cref="SplineBound"/>), millimetres: no point of the spline is farther from the source, and no point of the source is farther
    /// from the spline.</summary>
    public required double VerifiedBound { get; init; }

    /// <summary>Largest ratio of two neighbouring steps.</summary>
    public required double SpacingRatio { get; init; }

    /// <summary>Length of the source, millimetres.</summary>
    public required double Length { get; init; }

    /// <summary>Number of visited points, including both ends but not the two phantom points.</summary>
    public int Points => Lines.Count - 2;

    public Point2D Start => Lines[1];

    public Point2D End => Lines[^2];

    /// <summary>Height of one of <see cref="Lines"/>, millimetres.</summary>
    public double HeightAt(int line) => Heights is { } heights ? heights[line] : Z;

    /// <summary>The same trajectory at another height.</summary>
    public Trajectory Moved(double z) => this with { Z = z, Heights = Heights is { } heights ? [.. heights.Select(height => height + (z - Z))] : null };
}
