namespace Engraver.Core.Trajectories;

/// <summary>Options of trajectories.</summary>
/// <param name="MaxError">Largest error, millimetres, above 0: the proven bound of a dynamic density never exceeds it.</param>
public sealed record TrajectoryOptions(double MaxError)
{
    /// <summary>Null for the dynamic density; otherwise the largest length of equal steps, above 0, whose error is computed and reported, but not
    /// limited.</summary>
    public double? SegmentLength { get; init; }

    public CornerMode Corners { get; init; }

    /// <summary>The machining plane.</summary>
    public double Z { get; init; }
}
