namespace Engraver.Galil.Language;

/// <summary>One VP or CR of a vector sequence, in counts of the job's frame.</summary>
/// <remarks>Line: only <see cref="End"/> counts. Arc: radius, theta and delta exactly as they will be sent (already rounded to what the controller keeps);
/// <see cref="End"/> is where the controller is predicted to stand after it, rounded to counts (galil-dmc.md B.3).</remarks>
/// <param name="Kind">VP or CR.</param>
/// <param name="End">End point, job frame.</param>
/// <param name="Radius">CR radius, whole counts; 0 for a line.</param>
/// <param name="ThetaDegrees">CR theta: direction from the centre to the current point.</param>
/// <param name="DeltaDegrees">CR delta: signed sweep, counter-clockwise positive.</param>
/// <param name="EntityIndex">The drawing entity this piece engraves.</param>
/// <param name="Length">Path length in counts.</param>
public readonly record struct VectorSegment(
    VectorSegmentKind Kind, CountsPoint End, int Radius, double ThetaDegrees, double DeltaDegrees, int EntityIndex, double Length);

public enum VectorSegmentKind : byte
{
    /// <summary>VP x,y.</summary>
    Line,

    /// <summary>CR radius,theta,delta.</summary>
    Arc,
}
