namespace Engraver.Simulator.Motion;

/// <summary>One segment of a vector sequence in the sequence frame (galil-dmc.md B.2). Lengths in counts along the path.</summary>
internal abstract class VectorSegment
{
    /// <summary>Path length from the start of the sequence to the start of this segment.</summary>
    public double StartLength { get; set; }

    public double Length { get; protected init; }

    public double EndLength => StartLength + Length;

    /// <summary>The speed after "&lt;": commanded from the start of this segment (B.4).</summary>
    public double? EntrySpeed { get; set; }

    /// <summary>The speed after "&gt;": must be reached at the end of this segment (B.4).</summary>
    public double? ExitSpeed { get; set; }

    /// <summary>Frame coordinates at a distance from the start of this segment, 0 to <see cref="Length"/>.</summary>
    public abstract void PointAt(double distance, Span<double> point);

    /// <summary>Distance up to which no axis changes direction, starting at <paramref name="distance"/>.</summary>
    public virtual double OneWayUntil(double distance) => Length;

    /// <summary>Direction of travel in degrees, counter-clockwise from the first axis; -180 to 180 for straight segments.</summary>
    public abstract double TangentAt(double distance);
}
