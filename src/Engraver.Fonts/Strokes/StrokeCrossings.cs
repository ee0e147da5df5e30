namespace Engraver.Fonts.Strokes;

/// <summary>Where two pieces may cut each other.</summary>
internal static class StrokeCrossings
{
    /// <summary>How far lines and circles that touch may be apart, in font units.</summary>
    private const double Touching = 1e-3;

    /// <summary>The sine of the angle of parallel lines, and the distance of one centre.</summary>
    private const double Parallel = 1e-9;

    /// <returns>The common points of the lines and circles of both pieces, and the ends of the second one that are on the first one: pieces that touch or
    /// overlap are cut there.</returns>
    public static IEnumerable<FontPoint> Of(StrokePiece piece, StrokePiece other)
    {
        foreach (var end in new[] { other.Start, other.End })
        {
            if (piece.DistanceTo(end) < Touching) yield return end;
        }

        var points = (piece.IsLine, other.IsLine) switch
        {
            (true, true) => OfLines(piece, other),
            (true, false) => OfLineAndCircle(piece, other),
            (false, true) => OfLineAndCircle(other, piece),
            _ => OfCircles(piece, other),
        };
        foreach (var point in points) yield return point;
    }

    private static IEnumerable<FontPoint> OfLines(StrokePiece a, StrokePiece b)
    {
        var (ax, ay, bx, by) = (a.End.X - a.Start.X, a.End.Y - a.Start.Y, b.End.X - b.Start.X, b.End.Y - b.Start.Y);
        var cross = (ax * by) - (ay * bx);
        if (Math.Abs(cross) < Parallel * a.Chord * b.Chord) yield break;
        var at = (((b.Start.X - a.Start.X) * by) - ((b.Start.Y - a.Start.Y) * bx)) / cross;
        yield return new FontPoint(a.Start.X + (ax * at), a.Start.Y + (ay * at));
    }

    private static IEnumerable<FontPoint> OfLineAndCircle(StrokePiece line, StrokePiece arc)
    {
        var (centre, radius) = (arc.Centre, arc.Radius);
        var (dx, dy) = ((line.End.X - line.Start.X) / line.Chord, (line.End.Y - line.Start.Y) / line.Chord);
        var along = ((centre.X - line.Start.X) * dx) + ((centre.Y - line.Start.Y) * dy);
        FontPoint foot = new(line.Start.X + (dx * along), line.Start.Y + (dy * along));
        var away = StrokePiece.Distance(foot, centre);
        if (away > radius + Touching) yield break;
        var half = Math.Sqrt(Math.Max(0, (radius * radius) - (away * away)));
        yield return new FontPoint(foot.X + (dx * half), foot.Y + (dy * half));
        yield return new FontPoint(foot.X - (dx * half), foot.Y - (dy * half));
    }

    private static IEnumerable<FontPoint> OfCircles(StrokePiece a, StrokePiece b)
    {
        var (c, r, d, s) = (a.Centre, a.Radius, b.Centre, b.Radius);
        var apart = StrokePiece.Distance(c, d);
        if (apart < Parallel || apart > r + s + Touching || apart < Math.Abs(r - s) - Touching) yield break;
        var (dx, dy) = ((d.X - c.X) / apart, (d.Y - c.Y) / apart);
        var along = ((apart * apart) + (r * r) - (s * s)) / (2 * apart);
        var half = Math.Sqrt(Math.Max(0, (r * r) - (along * along)));
        yield return new FontPoint(c.X + (dx * along) - (dy * half), c.Y + (dy * along) + (dx * half));
        yield return new FontPoint(c.X + (dx * along) + (dy * half), c.Y + (dy * along) - (dx * half));
    }
}
