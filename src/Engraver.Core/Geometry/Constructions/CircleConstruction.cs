namespace Engraver.Core.Geometry.Constructions;

/// <summary>Circles from the values that a user gives. Null where they do not define one.</summary>
public static class CircleConstruction
{
    /// <summary>Counter-clockwise, starting right of the centre, as in DXF.</summary>
    public static ArcSegment? FromRadius(Point2D centre, double radius) => radius > 0.0 && double.IsFinite(radius) && centre.IsFinite ? new ArcSegment(centre, radius, Angle.Zero, Angle.FullTurn) : null;

    /// <summary>From two opposite points.</summary>
    public static ArcSegment? FromDiameter(Point2D one, Point2D other) => FromRadius(one + ((other - one) * 0.5), one.DistanceTo(other) / 2.0);

    public static ArcSegment? ThroughPoints(Point2D first, Point2D second, Point2D third) => ArcConstruction.ThroughPoints(first, second, third) is { } arc ? FromRadius(arc.Centre, arc.Radius) : null;

    /// <summary>The circle of a radius that touches two objects, with lines extended and arcs completed; of several, the one whose tangent points are nearest
    /// to the picked points.</summary>
    /// <param name="first">A line, arc or circle, and the point at which it was picked.</param>
    /// <param name="second">The second object and its point.</param>
    public static ArcSegment? TangentTo((Segment Of, Point2D At) first, (Segment Of, Point2D At) second, double radius)
    {
        if (first.Of.IsFreeCurve || second.Of.IsFreeCurve || !(radius > 0.0)) return null;
        var centres = from one in Loci(first.Of, radius) from other in Loci(second.Of, radius) from centre in one.Crossings(other) select centre;
        var best = centres.Cast<Point2D?>().MinBy(centre => Touch(first.Of, centre!.Value).DistanceTo(first.At) + Touch(second.Of, centre.Value).DistanceTo(second.At));
        return best is { } found ? FromRadius(found, radius) : null;
    }

    /// <summary>The loci of the centres of all circles of a radius that touch an object.</summary>
    private static IEnumerable<Locus> Loci(Segment of, double radius)
    {
        if (of.Kind != SegmentKind.Line) return new[] { of.Arc.Radius + radius, Math.Abs(of.Arc.Radius - radius) }.Where(away => away > 0.0).Select(away => new Locus(of.Arc.Centre, default, away));
        var direction = of.StartTangent;
        var left = new Vector2D(-direction.Y, direction.X) * radius;
        return direction.LengthSquared == 0.0 ? [] : [new Locus(of.Start + left, direction, 0.0), new Locus(of.Start - left, direction, 0.0)];
    }

    /// <summary>The point of an object, extended or completed, that is nearest to the centre of a circle that touches it.</summary>
    private static Point2D Touch(Segment of, Point2D centre)
    {
        if (of.Kind != SegmentKind.Line) return of.Arc.Centre + Vector2D.FromPolar(of.Arc.Radius, (centre - of.Arc.Centre).Direction);
        return of.Start + (of.StartTangent * (centre - of.Start).Dot(of.StartTangent));
    }

    /// <summary>A line through a point (with a direction of length 1), or a circle about it (with a radius).</summary>
    private readonly record struct Locus(Point2D Point, Vector2D Direction, double Radius)
    {
        public IEnumerable<Point2D> Crossings(Locus other)
        {
            if (Radius == 0.0 && other.Radius == 0.0) return OfLines(other);
            if (Radius == 0.0) return other.WithLine(Point, Direction);
            if (other.Radius == 0.0) return WithLine(other.Point, other.Direction);
            var apart = other.Point - Point;
            if (apart.LengthSquared == 0.0) return [];
            var along = (apart.LengthSquared + (Radius * Radius) - (other.Radius * other.Radius)) / (2.0 * apart.LengthSquared);
            return WithLine(Point + (apart * along), new Vector2D(-apart.Y, apart.X) * (1.0 / apart.Length));
        }

        private IEnumerable<Point2D> OfLines(Locus other)
        {
            var cross = Direction.Cross(other.Direction);
            return cross == 0.0 ? [] : [Point + (Direction * ((other.Point - Point).Cross(other.Direction) / cross))];
        }

        private IEnumerable<Point2D> WithLine(Point2D point, Vector2D direction)
        {
            var foot = point + (direction * (Point - point).Dot(direction));
            var left = (Radius * Radius) - (foot - Point).LengthSquared;
            if (left < -1e-12 * Radius * Radius) return [];
            var reach = Math.Sqrt(Math.Max(0.0, left));
            return [foot + (direction * reach), foot - (direction * reach)];
        }
    }
}
