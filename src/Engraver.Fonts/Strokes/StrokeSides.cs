namespace Engraver.Fonts.Strokes;

/// <summary>The curve at one distance around strokes of lines and arcs: the boundary of all points that are at most that far from a stroke.</summary>
/// <remarks>Both offsets of each piece and a circle around each end and joint are cut where they meet; a part is on the boundary if its middle is not closer
/// to any piece than the distance. The parts that remain are chained.</remarks>
internal static class StrokeSides
{
    /// <summary>How much closer than the distance the middle of a part of the boundary may be, in font units (a capital letter has about 700).</summary>
    private const double Rounding = 1e-5;

    /// <summary>Shorter parts are left out. Where two pieces join at an angle so small that the middle of what overlaps is within <see cref="Rounding"/>,
    /// the overlap is shorter than this.</summary>
    private const double ShortestPart = 0.03;

    /// <summary>How far ends that meet may be apart: two parts that were left out.</summary>
    private const double Gap = 2 * ShortestPart;

    public static IReadOnlyList<GlyphContour> Of(IReadOnlyList<GlyphContour> contours, double distance)
    {
        var ends = new List<FontPoint>();
        var pieces = contours.SelectMany(contour => Stroke.Of(contour).Pieces).Select(piece => new StrokePiece(Welded(piece.Start, ends), Welded(piece.End, ends), piece.Bulge))
            .Where(piece => piece.Start != piece.End).ToList();
        var sides = pieces.SelectMany(piece => SidesOf(piece, distance)).Concat(ends.SelectMany(point => CircleAround(point, distance))).ToList();
        var parts = new List<StrokePiece>();
        foreach (var side in sides)
        {
            foreach (var part in PartsOf(side, sides))
            {
                var middle = part.PointAt(0.5);
                if (part.Length > ShortestPart && pieces.All(piece => piece.DistanceTo(middle) >= distance - Rounding) && !parts.Exists(other => AreSame(other, part))) parts.Add(part);
            }
        }

        return [.. Chains(parts).Select(stroke => stroke.ToContour())];
    }

    /// <summary>The two offsets of a piece, with the piece on their left; only the outer one of an arc that is too small for the inner one.</summary>
    private static IEnumerable<StrokePiece> SidesOf(StrokePiece piece, double distance)
    {
        if (Shifted(piece, -distance) is { } right) yield return right;
        if (Shifted(piece, distance) is { } left) yield return left.Reversed();
    }

    /// <param name="distance">Positive to the left of the direction of travel.</param>
    private static StrokePiece? Shifted(StrokePiece piece, double distance)
    {
        // The centre of an arc that turns left is on its left.
        if (!piece.IsLine && piece.Radius - (distance * Math.Sign(piece.Bulge)) <= Gap) return null;
        return new StrokePiece(Beside(piece.Start, piece.StartDirection, distance), Beside(piece.End, piece.EndDirection, distance), piece.Bulge);
    }

    private static FontPoint Beside(FontPoint point, double direction, double distance)
    {
        var (sin, cos) = Math.SinCos(direction);
        return new FontPoint(point.X - (sin * distance), point.Y + (cos * distance));
    }

    /// <returns>The first end that is almost at the point: strokes that meet end at one point.</returns>
    private static FontPoint Welded(FontPoint point, List<FontPoint> ends)
    {
        foreach (var end in ends)
        {
            if (StrokePiece.Distance(end, point) < ShortestPart) return end;
        }

        ends.Add(point);
        return point;
    }

    private static StrokePiece[] CircleAround(FontPoint centre, double radius)
    {
        FontPoint right = new(centre.X + radius, centre.Y), left = new(centre.X - radius, centre.Y);
        return [new StrokePiece(right, left, 1), new StrokePiece(left, right, 1)];
    }

    private static IEnumerable<StrokePiece> PartsOf(StrokePiece side, List<StrokePiece> sides)
    {
        var cuts = new List<double> { 0, 1 };
        foreach (var other in sides.Where(other => other != side))
        {
            foreach (var point in StrokeCrossings.Of(side, other))
            {
                var at = side.FractionAt(point);
                if (at is > 0 and < 1 && other.DistanceTo(point) < Gap) cuts.Add(at);
            }
        }

        cuts.Sort();
        for (var i = 1; i < cuts.Count; i++)
        {
            if (cuts[i] > cuts[i - 1]) yield return side.Part(cuts[i - 1], cuts[i]);
        }
    }

    private static bool AreSame(StrokePiece a, StrokePiece b) =>
        StrokePiece.Distance(a.Start, b.Start) < ShortestPart / 2 && StrokePiece.Distance(a.End, b.End) < ShortestPart / 2 && StrokePiece.Distance(a.PointAt(0.5), b.PointAt(0.5)) < ShortestPart / 2;

    private static IEnumerable<Stroke> Chains(List<StrokePiece> parts)
    {
        while (parts.Count > 0)
        {
            var chain = new List<StrokePiece> { parts[^1] };
            parts.RemoveAt(parts.Count - 1);
            while (StrokePiece.Distance(chain[^1].End, chain[0].Start) > Gap && parts.Count > 0)
            {
                var next = parts.MinBy(part => StrokePiece.Distance(part.Start, chain[^1].End));
                if (StrokePiece.Distance(next.Start, chain[^1].End) > Gap) break;
                parts.Remove(next);
                chain.Add(next with { Start = chain[^1].End });
            }

            var isClosed = StrokePiece.Distance(chain[^1].End, chain[0].Start) <= Gap;
            if (isClosed) chain[^1] = chain[^1] with { End = chain[0].Start };
            yield return new Stroke(chain, isClosed);
        }
    }
}
