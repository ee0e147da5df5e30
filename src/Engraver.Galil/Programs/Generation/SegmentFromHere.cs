using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Generation;

/// <summary>A segment that is cut by itself, from where the machine really came to rest: its end stays where it was planned.</summary>
public static class SegmentFromHere
{
    /// <param name="planned">The segment as it was aimed from <paramref name="start"/>.</param>
    /// <param name="start">Where the machine was to stand.</param>
    /// <param name="here">Where it stands.</param>
    /// <returns>A CR aimed anew at the same end; the planned one where none keeps to the arc within a count. A line needs no aim.</returns>
    public static VectorSegment Aim(in VectorSegment planned, CountsPoint start, CountsPoint here, AngleQuantum quantum)
    {
        if (here == start || planned.Kind == VectorSegmentKind.Line) return planned;
        var radial = Vector2D.FromPolar(planned.Radius, Angle.FromDegrees(planned.ThetaDegrees));
        var wanted = new ArcSegment(new Point2D(start.X, start.Y) - radial, planned.Radius, Angle.FromDegrees(planned.ThetaDegrees), Angle.FromDegrees(planned.DeltaDegrees));
        var end = new Point2D(planned.End.X, planned.End.Y);
        return new ArcAim(quantum).ToEnd(new Point2D(here.X, here.Y), wanted, end, end) is { } aimed
            ? planned with { ThetaDegrees = aimed.ThetaDegrees, DeltaDegrees = aimed.DeltaDegrees, Length = aimed.Length }
            : planned;
    }
}
