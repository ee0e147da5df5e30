namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Two arcs (or lines) from one point and direction to another point and direction, joined without a corner.</summary>
/// <remarks>Such pairs form a family: with tangent lengths a and b the joint is on the line from start + a T0 to end - b T1, at distance a from the first and b
/// from the second.</remarks>
public readonly record struct Biarc(TangentArc First, TangentArc Second)
{
    /// <summary>The pair with equal tangent lengths, whose curvatures differ least. Null when the directions lead away from the chord or either arc would sweep
    /// a half turn.</summary>
    /// <param name="start">Start point.</param>
    /// <param name="startTangent">Direction there, length 1.</param>
    /// <param name="end">End point; not equal to the start.</param>
    /// <param name="endTangent">Direction of travel there, length 1.</param>
    public static Biarc? Between(Point2D start, Vector2D startTangent, Point2D end, Vector2D endTangent) => Between(start, startTangent, end, endTangent, 1.0);

    /// <summary>The pair whose first tangent length is <paramref name="share"/> times that of the pair with equal ones: the larger, the nearer the joint to the
    /// end.</summary>
    public static Biarc? Between(Point2D start, Vector2D startTangent, Point2D end, Vector2D endTangent, double share)
    {
        var chord = end - start;
        if (!(startTangent.Dot(chord) > 0.0) || !(endTangent.Dot(chord) > 0.0)) return null;
        var spread = Math.Max(0.0, 1.0 - startTangent.Dot(endTangent));
        var along = chord.Dot(startTangent + endTangent);
        var a = share * chord.LengthSquared / (along + Math.Sqrt((along * along) + (2.0 * spread * chord.LengthSquared)));
        var b = (chord.LengthSquared - (2.0 * a * chord.Dot(startTangent))) / (2.0 * (chord.Dot(endTangent) + (a * spread)));
        if (!(b > 0.0)) return null;
        var joint = start + (((startTangent * (a * b)) + ((chord - (endTangent * b)) * a)) * (1.0 / (a + b)));
        if (!(startTangent.Dot(joint - start) > 0.0) || !(endTangent.Dot(end - joint) > 0.0)) return null;
        return new Biarc(TangentArc.From(start, startTangent, joint), TangentArc.From(end, -endTangent, joint).Reversed());
    }
}
