namespace Engraver.Core.Geometry;

/// <summary>Two arcs (or lines) that leave one place in a given direction and reach another in a given direction, joined without a corner.</summary>
/// <remarks>Of the family of such pairs the one whose two tangent lengths are equal; it bends least unevenly.</remarks>
public readonly record struct Biarc(TangentArc First, TangentArc Second)
{
    /// <summary>The pair, or null when the directions lead away from the chord or either arc would sweep more than a quarter turn.</summary>
    /// <param name="start">Where it begins.</param>
    /// <param name="startTangent">Direction there, length 1.</param>
    /// <param name="end">Where it ends; another place.</param>
    /// <param name="endTangent">Direction of travel there, length 1.</param>
    public static Biarc? Between(Point2D start, Vector2D startTangent, Point2D end, Vector2D endTangent)
    {
        var chord = end - start;
        if (!(startTangent.Dot(chord) > 0.0) || !(endTangent.Dot(chord) > 0.0)) return null;
        var along = chord.Dot(startTangent + endTangent);
        var spread = 2.0 * (1.0 - startTangent.Dot(endTangent));
        var reach = chord.LengthSquared / (along + Math.Sqrt((along * along) + (Math.Max(0.0, spread) * chord.LengthSquared)));
        var joint = start + (chord * 0.5) + ((startTangent - endTangent) * (reach / 2.0));
        var first = TangentArc.From(start, startTangent, joint);
        var second = TangentArc.From(end, -endTangent, joint).Reversed();
        return first.IsAtMostQuarter && second.IsAtMostQuarter ? new Biarc(first, second) : null;
    }
}
