using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion.Planning;

/// <summary>A direction of travel in counts, length 1.</summary>
public readonly record struct PathDirection(double X, double Y, double Z)
{
    /// <summary>Angle to another direction, 0 to 180 degrees.</summary>
    public double TurnTo(PathDirection other) => 2.0 * Math.Asin(Math.Min(1.0, double.Hypot(double.Hypot(other.X - X, other.Y - Y), other.Z - Z) / 2.0)) * (180.0 / Math.PI);

    /// <summary>A direction in plan.</summary>
    public static PathDirection Of(Vector2D direction) => new(direction.X, direction.Y, 0.0);

    /// <summary>Directions in which a segment begins and ends.</summary>
    public static (PathDirection First, PathDirection Last) AtEnds(CountsPoint from, in VectorSegment segment)
    {
        if (segment.Kind == VectorSegmentKind.Arc) return (Of(SequenceKinematics.Direction(segment, from, 0.0)), Of(SequenceKinematics.Direction(segment, from, 1.0)));
        var way = segment.End - from;
        var direction = Of(way.X, way.Y, way.Z);
        return (direction, direction);
    }

    /// <summary>The direction of a way; zero for a way without length.</summary>
    public static PathDirection Of(double x, double y, double z)
    {
        var length = double.Hypot(double.Hypot(x, y), z);
        return length == 0.0 ? default : new PathDirection(x / length, y / length, z / length);
    }
}
