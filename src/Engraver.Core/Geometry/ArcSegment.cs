namespace Engraver.Core.Geometry;

/// <summary>Part of a circle with a direction. Counter-clockwise sweep is positive (DXF arcs always are; a contour may run them backwards).</summary>
/// <remarks>A whole turn is a sweep of exactly +-360 degrees; a sweep of zero is a point and is reported by the reader, not cut.</remarks>
public readonly record struct ArcSegment(Point2D Centre, double Radius, Angle Start, Angle Sweep)
{
    public Point2D StartPoint => Centre + Vector2D.FromPolar(Radius, Start);

    public Point2D EndPoint => IsFullTurn ? StartPoint : Centre + Vector2D.FromPolar(Radius, Start + Sweep);

    public bool IsFullTurn => Math.Abs(Sweep.Degrees) == 360.0;

    public double Length => Radius * Math.Abs(Sweep.Radians);

    /// <summary>Smallest box: the ends and every quadrant point that the sweep passes.</summary>
    public Bounds2D Bounds
    {
        get
        {
            var box = Bounds2D.FromCorners(StartPoint, EndPoint);
            for (var quadrant = 0; quadrant < 4; quadrant++)
            {
                var direction = Angle.FromDegrees(90.0 * quadrant);
                if (Covers(direction)) box = box.Including(Centre + Vector2D.FromPolar(Radius, direction));
            }

            return box;
        }
    }

    /// <summary>The arc through two points with the bulge of a polyline: tan(sweep / 4), counter-clockwise positive (DXF code 42).</summary>
    /// <remarks>The points must differ and the bulge must not be zero.</remarks>
    public static ArcSegment FromBulge(Point2D start, Point2D end, double bulge)
    {
        var chord = end - start;
        var sweep = Angle.FromRadians(4.0 * Math.Atan(bulge));
        var centreOffset = (1.0 - (bulge * bulge)) / (4.0 * bulge);
        var centre = new Point2D(
            ((start.X + end.X) / 2.0) - (chord.Y * centreOffset),
            ((start.Y + end.Y) / 2.0) + (chord.X * centreOffset));
        var radius = chord.Length * (1.0 + (bulge * bulge)) / (4.0 * Math.Abs(bulge));
        return new ArcSegment(centre, radius, (start - centre).Direction, sweep);
    }

    /// <summary>The same points in the opposite direction.</summary>
    public ArcSegment Reversed() => new(Centre, Radius, IsFullTurn ? Start : Start + Sweep, -Sweep);

    public Point2D PointAt(double fraction) => Centre + Vector2D.FromPolar(Radius, Start + (Sweep * fraction));

    /// <summary>Direction of travel (length 1) at a fraction of the sweep.</summary>
    public Vector2D TangentAt(double fraction)
    {
        var direction = Start + (Sweep * fraction);
        return Sweep.Degrees >= 0.0 ? new Vector2D(-direction.Sin(), direction.Cos()) : new Vector2D(direction.Sin(), -direction.Cos());
    }

    /// <summary>True when the arc passes through this direction seen from its centre (ends included).</summary>
    public bool Covers(Angle direction)
    {
        if (IsFullTurn) return true;
        var ahead = Sweep.Degrees >= 0.0 ? (direction - Start).Positive() : (Start - direction).Positive();
        return ahead <= Sweep.Abs() || ahead.Degrees == 0.0;
    }

    /// <summary>Shortest distance from a point to the arc, its ends included.</summary>
    public double DistanceTo(Point2D place)
    {
        var spoke = place - Centre;
        if (Covers(spoke.Direction)) return Math.Abs(spoke.Length - Radius);
        return Math.Min(StartPoint.DistanceTo(place), EndPoint.DistanceTo(place));
    }
}
