namespace Engraver.Core.Geometry.Biarcs;

/// <summary>An arc by its ends and its direction at the start; a line when its curvature is 0.</summary>
/// <param name="Start">Start point.</param>
/// <param name="StartTangent">Direction there, length 1.</param>
/// <param name="End">End point.</param>
/// <param name="EndTangent">Direction there, length 1.</param>
/// <param name="Curvature">1 / radius, left turns positive; 0 for a line.</param>
public readonly record struct TangentArc(Point2D Start, Vector2D StartTangent, Point2D End, Vector2D EndTangent, double Curvature)
{
    /// <summary>An arc whose height above the chord is below this part of the chord becomes a line: its centre would be lost in rounding.</summary>
    private const double StraightSagitta = 1e-9;

    /// <summary>The arc that leaves <paramref name="start"/> along <paramref name="tangent"/> and reaches <paramref name="end"/>.</summary>
    public static TangentArc From(Point2D start, Vector2D tangent, Point2D end)
    {
        var chord = end - start;
        var squared = chord.LengthSquared;
        var (along, across) = (tangent.Dot(chord), tangent.Cross(chord));
        if (!(Math.Abs(across) > 8.0 * StraightSagitta * Math.Sqrt(squared))) return new TangentArc(start, tangent, end, tangent, 0.0);
        var turned = ((chord * (2.0 * along)) - (tangent * squared)) * (1.0 / squared); // the tangent mirrored in the chord
        return new TangentArc(start, tangent, end, turned, 2.0 * across / squared);
    }

    /// <summary>The line between two points.</summary>
    public static TangentArc Straight(Point2D start, Point2D end)
    {
        var chord = end - start;
        var along = chord.Length is var length && length > 0.0 ? chord * (1.0 / length) : default;
        return new TangentArc(start, along, end, along, 0.0);
    }

    /// <summary>The same points in the opposite direction.</summary>
    public TangentArc Reversed() => new(End, -EndTangent, Start, -StartTangent, -Curvature);

    /// <summary>The arc as a segment with exactly these ends.</summary>
    public Segment ToSegment()
    {
        if (Curvature == 0.0) return Segment.FromLine(Start, End);
        var towards = new Vector2D(-StartTangent.Y, StartTangent.X) * (1.0 / Curvature);
        var sweep = Angle.FromRadians(2.0 * Math.Atan2(StartTangent.Cross(End - Start), StartTangent.Dot(End - Start)));
        return Segment.FromArc(new ArcSegment(Start + towards, towards.Length, (-towards).Direction, sweep), Start, End);
    }
}
