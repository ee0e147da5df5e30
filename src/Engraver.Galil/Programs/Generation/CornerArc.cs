using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs.Generation;

/// <summary>An arc that rounds a corner: tangent to both courses.</summary>
/// <param name="Arc">Counts; its radius is a whole number.</param>
/// <param name="Before">Length that it replaces at the end of the course before the corner.</param>
/// <param name="After">Length that it replaces at the start of the course after the corner.</param>
internal readonly record struct CornerArc(ArcSegment Arc, double Before, double After)
{
    /// <summary>A shorter arc is not cut alone, counts.</summary>
    private const double Shortest = 4.0;

    /// <summary>Sharper turns have no arc: it would have no radius.</summary>
    private const double SharpestDegrees = 179.0;

    private const int Halvings = 24;

    /// <summary>The largest arc within a tolerance.</summary>
    /// <param name="before">The course before the corner.</param>
    /// <param name="after">The course after it, which begins where the other one ends.</param>
    /// <param name="tolerance">Largest distance of the corner from the arc, counts.</param>
    /// <param name="most">Largest lengths to replace.</param>
    /// <param name="smallestRadius">Counts.</param>
    /// <param name="largestRadius">Counts.</param>
    /// <returns>Null where there is none.</returns>
    public static CornerArc? Largest(in PathCourse before, in PathCourse after, double tolerance, (double Before, double After) most, double smallestRadius, double largestRadius)
    {
        var turn = before.Shape.EndTangent.TurnTo(after.Shape.StartTangent);
        var half = turn.Abs().Degrees / 2.0;
        if (half <= 0.0 || 2.0 * half > SharpestDegrees) return null;
        var (sine, cosine) = (Angle.FromDegrees(half).Sin(), Angle.FromDegrees(half).Cos());
        var rise = 2.0 * Math.Pow(Angle.FromDegrees(half / 2.0).Sin(), 2.0); // 1 - cos(half), with its digits
        var reach = tolerance * sine / rise;
        var limits = (Before: Math.Min(most.Before, reach), After: Math.Min(most.After, reach));
        var radius = Math.Floor(Math.Min(largestRadius, Math.Min(limits.Before, limits.After) * cosine / sine));
        if (radius < smallestRadius || radius * turn.Abs().Radians < Shortest) return null;
        if (before.IsLine && after.IsLine) return Between(before, after, turn.Degrees > 0.0, radius);
        var corner = before.Shape.End;
        bool Fits(CornerArc? found) => found is { } arc && arc.Before <= limits.Before && arc.After <= limits.After && Math.Abs(arc.Arc.Centre.DistanceTo(corner) - arc.Arc.Radius) <= tolerance;
        if (Between(before, after, turn.Degrees > 0.0, radius) is var whole && Fits(whole)) return whole;
        var (low, high, best) = (smallestRadius - 1.0, radius, default(CornerArc?));
        for (var i = 0; i < Halvings && high - low > 1.0; i++)
        {
            var middle = Math.Floor((low + high) / 2.0);
            var found = Between(before, after, turn.Degrees > 0.0, middle);
            if (Fits(found)) (low, best) = (middle, found);
            else high = middle;
        }

        return best is { } fit && fit.Arc.Length >= Shortest ? best : null;
    }

    /// <summary>The arc of this radius that is tangent to both courses on the inner side of the turn; null where there is none near the corner.</summary>
    private static CornerArc? Between(in PathCourse before, in PathCourse after, bool isLeft, double radius)
    {
        var offset = isLeft ? radius : -radius;
        var corner = before.Shape.End;
        if (Centre(Offset.Of(before.Shape, atEnd: true, offset), Offset.Of(after.Shape, atEnd: false, offset), corner) is not { } centre) return null;
        var (first, last) = (Foot(before.Shape, centre), Foot(after.Shape, centre));
        if (first is not { } from || last is not { } to) return null;
        var start = (from.Place - centre).Direction;
        var sweep = from.Tangent.TurnTo(to.Tangent);
        if (sweep.Degrees > 0.0 != isLeft) return null;
        return new CornerArc(new ArcSegment(centre, radius, start, sweep), before.Shape.Length - from.Along, to.Along);
    }

    private static (Point2D Place, Vector2D Tangent, double Along)? Foot(in Segment shape, Point2D centre)
    {
        if (shape.Kind == SegmentKind.Line)
        {
            var tangent = shape.StartTangent;
            var along = (centre - shape.Start).Dot(tangent);
            return along < 0.0 || along > shape.Length ? null : (shape.Start + (tangent * along), tangent, along);
        }

        var arc = shape.Arc;
        var spoke = centre - arc.Centre;
        var direction = spoke.Direction;
        if (spoke.Length == 0.0 || !arc.Covers(direction)) return null;
        var swept = (arc.Sweep.Degrees >= 0.0 ? direction - arc.Start : arc.Start - direction).Positive();
        var fraction = Math.Min(1.0, swept.Degrees / arc.Sweep.Abs().Degrees);
        return (arc.PointAt(fraction), arc.TangentAt(fraction), fraction * arc.Length);
    }

    /// <summary>The point at the offset distance from both courses that is nearest to the corner.</summary>
    private static Point2D? Centre(Offset one, Offset other, Point2D corner)
    {
        if (!one.IsValid || !other.IsValid) return null;
        if (one.IsLine && other.IsLine)
        {
            var cross = one.Tangent.Cross(other.Tangent);
            return cross == 0.0 ? null : one.Place + (one.Tangent * ((other.Place - one.Place).Cross(other.Tangent) / cross));
        }

        if (one.IsLine) return Nearest(LineAndCircle(one, other), corner);
        return other.IsLine ? Nearest(LineAndCircle(other, one), corner) : Nearest(Circles(one, other), corner);
    }

    private static Point2D? Nearest((Point2D One, Point2D Other)? both, Point2D corner) =>
        both is { } places ? places.One.DistanceTo(corner) <= places.Other.DistanceTo(corner) ? places.One : places.Other : null;

    private static (Point2D One, Point2D Other)? LineAndCircle(Offset line, Offset circle)
    {
        var to = circle.Place - line.Place;
        var (along, away) = (to.Dot(line.Tangent), line.Tangent.Cross(to));
        var square = (circle.Radius * circle.Radius) - (away * away);
        if (square < 0.0) return null;
        var half = Math.Sqrt(square);
        return (line.Place + (line.Tangent * (along - half)), line.Place + (line.Tangent * (along + half)));
    }

    private static (Point2D One, Point2D Other)? Circles(Offset one, Offset other)
    {
        var way = other.Place - one.Place;
        var distance = way.Length;
        if (distance == 0.0) return null;
        var along = ((distance * distance) + (one.Radius * one.Radius) - (other.Radius * other.Radius)) / (2.0 * distance);
        var square = (one.Radius * one.Radius) - (along * along);
        if (square < 0.0) return null;
        var direction = way * (1.0 / distance);
        var (foot, normal) = (one.Place + (direction * along), new Vector2D(-direction.Y, direction.X) * Math.Sqrt(square));
        return (foot + normal, foot + (-normal));
    }

    /// <summary>The places at a distance to the left of a course near the corner: a line, or a circle.</summary>
    /// <param name="Place">Of a line a point, of a circle the centre.</param>
    /// <param name="Tangent">Of a line.</param>
    /// <param name="Radius">Of a circle; negative where there is none.</param>
    private readonly record struct Offset(bool IsLine, Point2D Place, Vector2D Tangent, double Radius)
    {
        public bool IsValid => IsLine || Radius >= 0.0;

        public static Offset Of(in Segment shape, bool atEnd, double left)
        {
            if (shape.Kind == SegmentKind.Line) return new Offset(true, (atEnd ? shape.End : shape.Start) + (new Vector2D(-shape.StartTangent.Y, shape.StartTangent.X) * left), shape.StartTangent, 0.0);
            var inwards = shape.Arc.Sweep.Degrees >= 0.0 ? left : -left;
            return new Offset(false, shape.Arc.Centre, default, shape.Arc.Radius - inwards);
        }
    }
}
