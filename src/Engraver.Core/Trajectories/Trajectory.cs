using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The points of one uniform Catmull-Rom spline and what is known of it: what a controller of the SACE bench or an XPS runs (paper 004).</summary>
public sealed record Trajectory
{
    /// <summary>As they stand in the file, millimetres of the drawing, rounded to nine decimals: the phantom point that gives the start tangent, the points visited, the phantom of the end.</summary>
    public required IReadOnlyList<Point2D> Lines { get; init; }

    /// <summary>Height of all of it, millimetres; of one with <see cref="Heights"/> where it starts.</summary>
    public double Z { get; init; }

    /// <summary>For each of <see cref="Lines"/>, millimetres, where they differ (a helix); null: all of it lies at <see cref="Z"/>.</summary>
    public IReadOnlyList<double>? Heights { get; init; }

    /// <summary>The lengths along the source that belong to the points visited, millimetres, increasing; of a closed one the last is the first plus one round.</summary>
    public required IReadOnlyList<double> Knots { get; init; }

    /// <summary>What it follows: the segments of a contour from corner to corner, or all of them.</summary>
    public required IReadOnlyList<Segment> Source { get; init; }

    /// <summary>True when it ends where it starts without a corner there; the spline is then periodic.</summary>
    public required bool Closed { get; init; }

    /// <summary>Largest distance at dense samples, millimetres; for the eye, never the measure.</summary>
    public required double SampledError { get; init; }

    /// <summary>No point of the spline is farther from the source, and none of the source from the spline: proven (<see cref="SplineBound"/>), millimetres.</summary>
    public required double VerifiedBound { get; init; }

    /// <summary>Largest ratio of two neighbouring steps.</summary>
    public required double SpacingRatio { get; init; }

    /// <summary>Of the source, millimetres.</summary>
    public required double Length { get; init; }

    /// <summary>Points visited: both ends included, the two phantoms not.</summary>
    public int Points => Lines.Count - 2;

    public Point2D Start => Lines[1];

    public Point2D End => Lines[^2];

    /// <summary>Height of one of <see cref="Lines"/>, millimetres.</summary>
    public double HeightAt(int line) => Heights is { } heights ? heights[line] : Z;

    /// <summary>The same at another height.</summary>
    public Trajectory Moved(double z) => this with { Z = z, Heights = Heights is { } heights ? [.. heights.Select(height => height + (z - Z))] : null };
}

/// <summary>How trajectories are made.</summary>
/// <param name="MaxError">Millimetres, above 0: the proven bound of a dynamic density never exceeds it.</param>
public sealed record TrajectoryOptions(double MaxError)
{
    /// <summary>SACETraj's: 0.5 mm.</summary>
    public const double DefaultSegmentLength = 0.5;

    /// <summary>Null for the dynamic density; otherwise the largest length of equal steps, above 0, whose error is computed and told, not limited.</summary>
    public double? SegmentLength { get; init; }

    public CornerMode Corners { get; init; } = CornerMode.Stop;

    /// <summary>The machining plane.</summary>
    public double Z { get; init; }
}

/// <summary>What becomes of corners (sharper than 0.05 degrees).</summary>
public enum CornerMode
{
    /// <summary>A trajectory ends at a corner and another begins: the corner stays sharp, the machine stops.</summary>
    Stop,

    /// <summary>One trajectory runs through with points so close to the corner that the rounding stays within the error.</summary>
    Continuous,
}
