using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Decides whether chords follow a circle: near enough at every point, in both directions, and with the same turn as the circle.</summary>
/// <remarks>
/// Between two vertices in order round the centre, chord and arc cover the same directions from the centre, so their distance is the difference of their radii.
/// Along a chord the radius is extreme at its ends and at the foot of the perpendicular from the centre: a check of these covers every point.
/// </remarks>
internal readonly ref struct ChordProof(Point2D centre, double radius, double turn, in ChordTolerances tolerances)
{
    /// <summary>Sine of the largest corner between two chords of an arc: 30 degrees. A hexagon turns by 60, an octagon by 45, and such polygons are kept as
    /// drawn.</summary>
    public const double LargestCorner = 0.5;

    /// <summary>Fraction by which a corner may differ from that of the circle; exact chords of a circle have exactly its corners, even when they differ in
    /// length.</summary>
    public const double UnevenTurn = 0.6;

    private readonly double _maxError = tolerances.MaxError;
    private readonly double _rounding = tolerances.Rounding;

    /// <param name="vertices">Vertices in the order of travel.</param>
    /// <param name="closed">True when the last chord ends at the first vertex.</param>
    /// <param name="deviation">Largest distance between chords and circle; not meaningful when the result is false.</param>
    /// <param name="length">Total length of the chords.</param>
    public bool IsProven(ReadOnlySpan<Point2D> vertices, bool closed, out double deviation, out double length)
    {
        (deviation, length) = (0.0, 0.0);
        var before = closed ? vertices[0] - vertices[^1] : default;
        var chords = closed ? vertices.Length : vertices.Length - 1;
        for (var i = 0; i < chords; i++)
        {
            var (from, to) = (vertices[i], vertices[i + 1 < vertices.Length ? i + 1 : 0]);
            var chord = to - from;
            if ((closed || i > 0) && !Turns(before, chord)) return false;
            if (!IsNear(from - centre, chord, ref deviation)) return false;
            length += Math.Sqrt(chord.LengthSquared);
            before = chord;
        }

        return true;
    }

    private bool IsNear(Vector2D spoke, Vector2D chord, ref double deviation)
    {
        var progress = spoke.Cross(chord) * turn;
        if (!(progress > 0.0)) return false;
        var foot = progress / Math.Sqrt(chord.LengthSquared);
        deviation = Math.Max(deviation, Math.Max(Math.Abs(Math.Sqrt(spoke.LengthSquared) - radius), Math.Abs(foot - radius)));
        return deviation <= _maxError;
    }

    private bool Turns(Vector2D before, Vector2D after)
    {
        var (first, second) = (Math.Sqrt(before.LengthSquared), Math.Sqrt(after.LengthSquared));
        var corner = before.Cross(after) * turn / (first * second);
        var due = (first + second) / (2.0 * radius);
        return before.Dot(after) > 0.0 && corner <= LargestCorner && Math.Abs(corner - due) <= (UnevenTurn * due) + (4.0 * _rounding / Math.Min(first, second));
    }
}
