using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Remaining part of a line or arc at a fillet.</summary>
/// <param name="Remaining">Cut or lengthened at the fillet (part 0).</param>
/// <param name="EndsAtJoint">True when it runs from its start to the fillet; otherwise it runs from the fillet to its end.</param>
public readonly record struct FilletSide(PathRange Remaining, bool EndsAtJoint)
{
    /// <summary>The point where it meets the fillet.</summary>
    public Point2D Joint => EndsAtJoint ? Remaining.End : Remaining.Start;

    internal static FilletSide Of(Segment segment, double fraction, Point2D at, bool endsThere) => endsThere
        ? new FilletSide(new PathRange(0, 0.0, fraction, segment.Start, at), true)
        : new FilletSide(new PathRange(0, fraction, 1.0, at, segment.End), false);
}
