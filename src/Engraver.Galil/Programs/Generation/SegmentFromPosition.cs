using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Adapts a segment that is cut separately to the position at which the machine actually came to rest; its end is unchanged.</summary>
public static class SegmentFromPosition
{
    /// <param name="planned">The segment as computed from <paramref name="start"/>.</param>
    /// <param name="start">Planned position of the machine.</param>
    /// <param name="here">Actual position.</param>
    /// <returns>A CR recalculated for the same end; the planned one if no CR is within a count of the arc. A line needs no change.</returns>
    public static VectorSegment Adapt(in VectorSegment planned, CountsPoint start, CountsPoint here, AngleQuantum quantum)
    {
        if (here == start || planned.Kind == VectorSegmentKind.Line) return planned;
        var radial = Vector2D.FromPolar(planned.Radius, Angle.FromDegrees(planned.ThetaDegrees));
        var wanted = new ArcSegment(new Point2D(start.X, start.Y) - radial, planned.Radius, Angle.FromDegrees(planned.ThetaDegrees), Angle.FromDegrees(planned.DeltaDegrees));
        var end = new Point2D(planned.End.X, planned.End.Y);
        return new ArcCommandFit(quantum).ToEnd(new Point2D(here.X, here.Y), wanted, end, end) is { } aimed
            ? planned with { ThetaDegrees = aimed.ThetaDegrees, DeltaDegrees = aimed.DeltaDegrees, Length = aimed.Length }
            : planned;
    }
}
