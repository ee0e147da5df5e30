using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>The corners and necks of a region that the round tool cannot reach.</summary>
internal static class UnreachableMaterial
{
    /// <summary>Distance from the reached area beyond which a wall counts as not reached, millimetres.</summary>
    private const double MinDistance = 2e-6;

    /// <param name="walls">Walls of the region, material on the left.</param>
    /// <param name="centres">Loops around the area of the tool's centre.</param>
    /// <param name="reached">The area that the tool reaches: the loops at the radius around those.</param>
    /// <param name="radius">Radius of the tool.</param>
    public static List<UnreachedPlace> Find(IReadOnlyList<PathPiece[]> walls, IReadOnlyList<PathPiece[]> centres, IReadOnlyList<OffsetLoop> reached, double radius)
    {
        var reach = new SweptReach([.. centres.SelectMany(loop => loop)], radius + MinDistance);
        List<WallStretch> stretches = [.. walls.SelectMany(wall => Stretches(wall, piece => reach.PartsOutside(piece), _ => false))];
        var wall = new SweptReach([.. walls.SelectMany(loop => loop)], radius);
        List<WallStretch> arcs = [.. reached.SelectMany(loop => Stretches([.. loop.Segments.Select(segment => PathPiece.FromSegment(segment))], piece => wall.Distance(piece.At(0.5)) > 0.5 * MinDistance ? [PiecePart.Whole] : [], joint => wall.Distance(joint) <= 0.5 * MinDistance))];
        var places = new List<UnreachedPlace>();
        while (stretches.Count > 0) places.Add(AddPlace(stretches, arcs, reach, radius));
        return places;
    }

    /// <summary>Follows the boundary of one unreached piece: along the wall, back along the reached area, until it is closed.</summary>
    private static UnreachedPlace AddPlace(List<WallStretch> stretches, List<WallStretch> arcs, SweptReach reach, double radius)
    {
        var (border, farthest, depth) = (new List<Segment>(), stretches[0].Pieces[0].At(0.5), 0.0);
        var start = stretches[0].Pieces[0].Start;
        for (var stretch = stretches[0]; ;)
        {
            stretches.Remove(stretch);
            foreach (var place in stretch.Pieces.SelectMany(piece => (Point2D[])[piece.Start, piece.At(0.5), piece.End]))
            {
                if (reach.Distance(place) - radius is var away && away > depth) (farthest, depth) = (place, away);
            }

            border.AddRange(stretch.Pieces.Select(piece => piece.ToSegment()));
            if (stretch.Pieces[^1].End == start) break;
            if (Nearest(arcs, arc => arc.Pieces[^1].End, stretch.Pieces[^1].End, radius) is not { } back) return new UnreachedPlace(farthest, depth, null);
            for (var i = back.Pieces.Length - 1; i >= 0; i--) border.Add(back.Pieces[i].Reversed().ToSegment());
            arcs.Remove(back);
            if (back.Pieces[0].Start.DistanceTo(start) <= Near(radius)) break;
            if (Nearest(stretches, next => next.Pieces[0].Start, back.Pieces[0].Start, radius) is not { } onwards) return new UnreachedPlace(farthest, depth, null);
            stretch = onwards;
        }

        return new UnreachedPlace(farthest, depth, ChainArea.Of(Closed(border)));
    }

    private static double Near(double radius) => 0.1 * radius;

    private static WallStretch? Nearest(List<WallStretch> stretches, Func<WallStretch, Point2D> end, Point2D place, double radius) =>
        stretches.Where(stretch => end(stretch).DistanceTo(place) <= Near(radius)).MinBy(stretch => end(stretch).DistanceTo(place));

    /// <summary>With lines across the gaps where the wall leaves the reached area tangentially.</summary>
    private static List<Segment> Closed(List<Segment> border)
    {
        var closed = new List<Segment>(2 * border.Count);
        for (var i = 0; i < border.Count; i++)
        {
            closed.Add(border[i]);
            var next = border[(i + 1) % border.Count];
            if (border[i].End != next.Start) closed.Add(Segment.FromLine(border[i].End, next.Start));
        }

        return closed;
    }

    /// <summary>Consecutive parts of a closed chain, interrupted where a joint touches the source of the parts.</summary>
    private static List<WallStretch> Stretches(PathPiece[] chain, Func<PathPiece, IReadOnlyList<PiecePart>> partsOf, Func<Point2D, bool> breaksAt)
    {
        var runs = new List<List<PathPiece>>();
        foreach (var piece in chain)
        {
            foreach (var part in partsOf(piece))
            {
                var cut = part == PiecePart.Whole ? piece : piece.Part(part.From, part.From == 0.0 ? piece.Start : piece.At(part.From), part.To, part.To == 1.0 ? piece.End : piece.At(part.To));
                if (runs is [.., var last] && last[^1].End == cut.Start && !breaksAt(cut.Start)) last.Add(cut);
                else runs.Add([cut]);
            }
        }

        if (runs.Count > 1 && runs[^1][^1].End == runs[0][0].Start && !breaksAt(runs[0][0].Start))
        {
            runs[^1].AddRange(runs[0]);
            runs.RemoveAt(0);
        }

        return [.. runs.Select(run => new WallStretch([.. run]))];
    }

    private sealed record WallStretch(PathPiece[] Pieces);
}
