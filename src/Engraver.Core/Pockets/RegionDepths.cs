using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>The loops of a region at a distance from its walls, always from the walls themselves and never from another loop, so that errors do not
/// accumulate.</summary>
internal sealed class RegionDepths(PocketRegion region, OffsetOptions options)
{
    /// <summary>Millimetres by which a channel may be narrower than the tool and still be cut: the last digit of a drawing with six decimals.</summary>
    private const double Rounding = 5e-7;

    /// <summary>Additional length of the loops from which on such a channel was found.</summary>
    private const double MinChannelLength = 1e-4;

    public List<Point2D> Unresolved { get; } = [];

    public double MaxDeviation { get; private set; }

    /// <summary>Closed loops with the deeper area on their left; empty when no point is as deep.</summary>
    public List<PathPiece[]> At(double distance)
    {
        var result = ContourOffset.Offset(region.Contours, distance - region.Inset, OffsetSide.In, options);
        MaxDeviation = Math.Max(MaxDeviation, result.MaxDeviation);
        Unresolved.AddRange(result.Unresolved);
        return [.. result.Loops.Select(loop => (PathPiece[])[.. loop.Segments.Select(segment => PathPiece.FromSegment(segment))])];
    }

    /// <summary>The same at the tool's radius, with the channels that are exactly as wide as the tool.</summary>
    /// <returns>The loops around the area of the tool's centre, and the passes along them: once along a channel and not there and back.</returns>
    public (List<PathPiece[]> Loops, List<PathPiece[]> Passes) AtRadius(double radius)
    {
        var (exact, wider) = (At(radius), At(radius - Rounding));
        return exact.Count == 0 || LengthOf(wider) > LengthOf(exact) + MinChannelLength ? (wider, WithoutReturns(wider)) : (exact, exact);
    }

    /// <summary>The widest point of a region, and its width, for a region in which no point is as deep as the radius.</summary>
    public NarrowRegion Widest(double radius)
    {
        var (low, high, place) = (0.0, radius, region.Walls[0][0].Start);
        for (var halvings = 0; halvings < 30 && high - low > 1e-7; halvings++)
        {
            var middle = (low + high) / 2.0;
            var loops = At(middle);
            if (loops.Count == 0) high = middle;
            else (low, place) = (middle, loops.MaxBy(loop => loop.Sum(piece => piece.Length))![0].At(0.5));
        }

        return new NarrowRegion(place, 2.0 * low);
    }

    /// <summary>A loop there and back along a channel becomes a single path, two loops around a ring become one.</summary>
    private static List<PathPiece[]> WithoutReturns(List<PathPiece[]> loops)
    {
        var kept = new List<PathPiece[]>();
        foreach (var loop in loops)
        {
            if (kept.Exists(other => Coincide(loop, other))) continue;
            kept.Add(OneWay(loop) ?? loop);
        }

        return kept;
    }

    private static bool Coincide(PathPiece[] loop, PathPiece[] other) =>
        Math.Abs(loop.Sum(piece => piece.Length) - other.Sum(piece => piece.Length)) < 100.0 * Rounding
        && loop.All(piece => other.Any(beside => beside.DistanceTo(piece.At(0.5)) < 4.0 * Rounding));

    /// <summary>One side of a loop that encloses no area; null for every other loop, also for a loop with branches.</summary>
    private static PathPiece[]? OneWay(PathPiece[] loop)
    {
        int[] ends = [.. Enumerable.Range(0, loop.Length).Where(i => loop[i].Length < 10.0 * Rounding)];
        if (ends.Length != 2) return null;
        PathPiece[] there = [.. loop[(ends[0] + 1)..ends[1]]];
        PathPiece[] back = [.. loop[(ends[1] + 1)..], .. loop[..ends[0]]];
        if (there.Length == 0 || back.Length == 0) return null;
        return there.All(piece => back.Any(beside => beside.DistanceTo(piece.At(0.5)) < 4.0 * Rounding)) ? there : null;
    }

    private static double LengthOf(List<PathPiece[]> loops) => loops.Sum(loop => loop.Sum(piece => piece.Length));
}
