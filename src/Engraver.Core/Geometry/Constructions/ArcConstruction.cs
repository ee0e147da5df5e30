namespace Engraver.Core.Geometry.Constructions;

/// <summary>Arcs from the values that a user gives: points, centre, angle, chord, radius, direction. The methods of the command ARC.</summary>
/// <remarks>Every arc begins at its start point. Null where the values do not define an arc: points that are collinear or coincide, a chord longer than the
/// diameter.</remarks>
public static class ArcConstruction
{
    /// <summary>Sine of the smallest angle between two chords of an arc: a flatter arc has a radius beyond 1e9 times its length, and is a line.</summary>
    private const double Flattest = 1e-9;

    /// <summary>Maximum excess of a chord over the diameter, as a part of it: the rounding of a half circle.</summary>
    private const double Rounding = 1e-12;

    /// <summary>From the start through the second point to the end, in either direction.</summary>
    public static ArcSegment? ThroughPoints(Point2D start, Point2D second, Point2D end)
    {
        var (b, c) = (second - start, end - start);
        var cross = b.Cross(c);
        if (!(Math.Abs(cross) > Flattest * b.Length * c.Length) || !((end - second).Length > Flattest * c.Length)) return null;
        var (bb, cc) = (b.LengthSquared, c.LengthSquared);
        var spoke = new Vector2D(((c.Y * bb) - (b.Y * cc)) / (2.0 * cross), ((b.X * cc) - (c.X * bb)) / (2.0 * cross));
        var centre = start + spoke;
        var (from, to) = ((start - centre).Direction, (end - centre).Direction);
        return Made(centre, spoke.Length, from, cross > 0.0 ? (to - from).Positive() : -(from - to).Positive());
    }

    /// <summary>Counter-clockwise from the start about the centre to the direction of a point, which need not be on the circle.</summary>
    public static ArcSegment? FromCentreTo(Point2D start, Point2D centre, Point2D toward)
    {
        if (toward == centre) return null;
        var from = (start - centre).Direction;
        return Made(centre, start.DistanceTo(centre), from, ((toward - centre).Direction - from).Positive());
    }

    /// <param name="sweep">Included angle, counter-clockwise positive; below a whole turn.</param>
    public static ArcSegment? FromCentreSweep(Point2D start, Point2D centre, Angle sweep) => Made(centre, start.DistanceTo(centre), (start - centre).Direction, sweep);

    /// <summary>Counter-clockwise about the centre until the straight distance from the start is the chord.</summary>
    /// <param name="chord">Positive for the shorter arc, negative for the longer one.</param>
    public static ArcSegment? FromCentreChord(Point2D start, Point2D centre, double chord) => OfChord(Math.Abs(chord), start.DistanceTo(centre), chord < 0.0) is { } sweep ? FromCentreSweep(start, centre, sweep) : null;

    /// <param name="sweep">Included angle, counter-clockwise positive; below a whole turn.</param>
    public static ArcSegment? FromEndsSweep(Point2D start, Point2D end, Angle sweep)
    {
        if (start == end || sweep.Degrees == 0.0 || !(Math.Abs(sweep.Degrees) < 360.0)) return null;
        var arc = ArcSegment.FromBulge(start, end, Math.Tan(sweep.Radians / 4.0));
        return Made(arc.Centre, arc.Radius, arc.Start, sweep);
    }

    /// <summary>Counter-clockwise from the start to the end.</summary>
    /// <param name="radius">Positive for the shorter arc, negative for the longer one.</param>
    public static ArcSegment? FromEndsRadius(Point2D start, Point2D end, double radius) => OfChord(start.DistanceTo(end), Math.Abs(radius), radius < 0.0) is { } sweep ? FromEndsSweep(start, end, sweep) : null;

    /// <summary>From the start to the end, beginning in a direction.</summary>
    /// <param name="direction">Direction of travel at the start; its length does not matter.</param>
    public static ArcSegment? FromEndsDirection(Point2D start, Point2D end, Vector2D direction)
    {
        var turn = direction.TurnTo(end - start);
        return direction.LengthSquared > 0.0 && Math.Abs(turn.Sin()) > Flattest ? FromEndsSweep(start, end, turn * 2.0) : null;
    }

    /// <summary>The angle of a chord; null when the chord is longer than the diameter.</summary>
    private static Angle? OfChord(double chord, double radius, bool longer)
    {
        if (!(chord > 0.0) || chord > 2.0 * radius * (1.0 + Rounding)) return null;
        var sweep = Angle.FromRadians(2.0 * Math.Asin(Math.Min(1.0, chord / (2.0 * radius))));
        return longer ? Angle.FullTurn - sweep : sweep;
    }

    private static ArcSegment? Made(Point2D centre, double radius, Angle start, Angle sweep) =>
        centre.IsFinite && double.IsFinite(radius) && radius > 0.0 && sweep.Degrees != 0.0 && Math.Abs(sweep.Degrees) < 360.0 ? new ArcSegment(centre, radius, start.Positive(), sweep) : null;
}
