using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Speed and acceleration along one vector sequence, from rest to rest, as the controller runs it (galil-dmc.md B.5). Places are distances along the
/// sequence in counts; results are in millimetres.</summary>
/// <param name="planned">Speed along the path.</param>
public sealed class SequenceKinematics(SequenceProfile planned, CountsScale scale)
{
    /// <summary>Speed along the path, counts/s.</summary>
    public double SpeedAt(double path) => planned.SpeedAt(path);

    /// <summary>Velocity of the axes, mm/s.</summary>
    /// <param name="segment">The segment that contains <paramref name="path"/>.</param>
    /// <param name="from">Start of the segment.</param>
    /// <param name="fraction">Place on the segment, 0 to 1.</param>
    public Vector2D VelocityAt(in VectorSegment segment, CountsPoint from, double fraction, double path) => scale.ToMillimetres(Direction(segment, from, fraction) * SpeedAt(path));

    /// <summary>Acceleration of the axes, mm/s2: along the path, and towards the centre of an arc.</summary>
    /// <param name="segment">As for <see cref="VelocityAt"/>.</param>
    /// <param name="from">As for <see cref="VelocityAt"/>.</param>
    /// <param name="fraction">As for <see cref="VelocityAt"/>.</param>
    /// <param name="rampPlace">Place at which the acceleration along the path is taken; null for <paramref name="path"/>. At an end of a ramp a place beside
    /// it selects the value before or after.</param>
    public Vector2D AccelerationAt(in VectorSegment segment, CountsPoint from, double fraction, double path, double? rampPlace = null)
    {
        var direction = Direction(segment, from, fraction);
        return scale.ToMillimetres((direction * planned.GainAt(rampPlace ?? path)) + Inwards(segment, direction, SpeedAt(path)));
    }

    /// <summary>Direction of travel, length 1 in counts; zero for a line without length.</summary>
    public static Vector2D Direction(in VectorSegment segment, CountsPoint from, double fraction)
    {
        if (segment.Kind == VectorSegmentKind.Line)
        {
            var way = new Vector2D((double)segment.End.X - from.X, (double)segment.End.Y - from.Y);
            return way.Length > 0.0 ? way * (1.0 / way.Length) : default;
        }

        var spoke = Angle.FromDegrees(segment.ThetaDegrees + (fraction * segment.DeltaDegrees));
        return new Vector2D(-spoke.Sin(), spoke.Cos()) * Math.Sign(segment.DeltaDegrees);
    }

    /// <summary>Towards the centre of an arc: v2/r.</summary>
    private static Vector2D Inwards(in VectorSegment segment, Vector2D direction, double speed) => segment.Kind == VectorSegmentKind.Line
        ? default
        : new Vector2D(-direction.Y, direction.X) * (Math.Sign(segment.DeltaDegrees) * speed * speed / segment.Radius);
}
