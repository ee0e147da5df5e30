using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Descents on a circle that touches the first move of a stroke at its start, by whole turns.</summary>
/// <param name="ramp">The angle of descent.</param>
/// <param name="radiusMm">Radius of the circle, above 0.</param>
/// <param name="clearance">Distance of a place from the nearest contour of a part.</param>
/// <param name="leastMm">The smallest allowed distance.</param>
/// <param name="maxErrorMm">Largest distance of a chord from the circle.</param>
internal sealed class HelixEntry(RampEntry ramp, double radiusMm, Func<Point2D, double> clearance, double leastMm, double maxErrorMm)
{
    /// <summary>A circle without room is made smaller, down to this part of the stated radius.</summary>
    private const double SmallestPart = 0.25;

    private const double Rounding = 1e-6;

    /// <summary>The moves from the depth before to the start of the first move at its depth.</summary>
    /// <param name="first">The lead, or the first move of the stroke; in plan.</param>
    /// <returns>Empty where there is nothing to descend; null where no circle has room.</returns>
    public IReadOnlyList<StrokeMove>? To(in StrokeMove first, double before, double depth)
    {
        if (ramp.LengthOf(depth - before) is not (> 0.0 and var length)) return [];
        var (start, tangent) = (first.Segment.Start, first.Segment.StartTangent);
        var left = new Vector2D(-tangent.Y, tangent.X);
        for (var radius = radiusMm; radius >= SmallestPart * radiusMm; radius /= 2.0)
        {
            Vector2D[] sides = clearance(start + (left * radius)) >= clearance(start - (left * radius)) ? [left, left * -1.0] : [left * -1.0, left];
            foreach (var side in sides)
            {
                if (HasRoom(start + (side * radius), radius)) return [.. ChordPath.Sloped(Turns(first, start + (side * radius), radius, side == left, length), -before, -depth, StrokeRole.Ramp)];
            }
        }

        return null;
    }

    /// <summary>A place of the circle is at most half a turn away from one that is followed.</summary>
    private bool HasRoom(Point2D centre, double radius)
    {
        var (angle, least) = (0.0, leastMm - maxErrorMm - Rounding);
        while (angle < 2.0 * Math.PI)
        {
            var distance = clearance(centre + (new Vector2D(Math.Cos(angle), Math.Sin(angle)) * radius));
            if (distance < least) return false;
            angle += Math.Max(0.01 * leastMm, distance - leastMm) / radius;
        }

        return true;
    }

    private IReadOnlyList<StrokeMove> Turns(StrokeMove of, Point2D centre, double radius, bool isLeft, double length)
    {
        var (start, sweep) = (of.Segment.Start, Angle.FromDegrees(isLeft ? 180.0 : -180.0));
        var opposite = centre + (centre - start);
        StrokeMove[] turn =
        [
            of with { Segment = Segment.FromArc(new ArcSegment(centre, radius, (start - centre).Direction, sweep), start, opposite) },
            of with { Segment = Segment.FromArc(new ArcSegment(centre, radius, (opposite - centre).Direction, sweep), opposite, start) },
        ];
        var chords = ChordPath.Of(turn, maxErrorMm);
        var turns = Math.Max(1, (int)Math.Ceiling(length / chords.Sum(chord => chord.Segment.Length)));
        return [.. Enumerable.Range(0, turns).SelectMany(_ => chords)];
    }
}
