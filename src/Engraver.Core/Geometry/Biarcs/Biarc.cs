namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Two arcs (or lines) that leave one place in a given direction and reach another in a given direction, joined without a corner.</summary>
/// <remarks>There is a family of such pairs: with tangent lengths a and b the joint lies on the line from start + a T0 to end - b T1, a from the one and b from the other.</remarks>
public readonly record struct Biarc(TangentArc First, TangentArc Second)
{
    /// <summary>The pair whose two tangent lengths are equal; it bends least unevenly. Null when the directions lead away from the chord or either arc would sweep a half turn.</summary>
    /// <param name="start">Where it begins.</param>
    /// <param name="startTangent">Direction there, length 1.</param>
    /// <param name="end">Where it ends; another place.</param>
    /// <param name="endTangent">Direction of travel there, length 1.</param>
    public static Biarc? Between(Point2D start, Vector2D startTangent, Point2D end, Vector2D endTangent) => Between(start, startTangent, end, endTangent, 1.0);

    /// <summary>The pair whose first tangent length is <paramref name="share"/> times that of the pair with equal ones: the larger, the later the joint.</summary>
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
