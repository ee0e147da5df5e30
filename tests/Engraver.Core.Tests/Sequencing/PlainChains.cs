using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Tests.Sequencing;

/// <summary>The rule of <see cref="ContourChainer"/> in plain form, for open segments at one height: every end is tested in every step.</summary>
internal static class PlainChains
{
    private const double SameTurn = 1e-9;
    private const double SmallGap = 1e-3;

    /// <summary>The pieces of each contour, as text.</summary>
    public static IEnumerable<string> Of(Segment[] segments, double tolerance)
    {
        var used = new bool[segments.Length];
        for (var row = 0; row < segments.Length; row++)
        {
            if (used[row]) continue;
            used[row] = true;
            var ahead = new List<ContourPiece> { new(row, Reversed: false) };
            if (!Grow(segments, used, ahead, row, tolerance))
            {
                var behind = new List<ContourPiece> { new(row, Reversed: true) };
                Grow(segments, used, behind, -1, tolerance);
                ahead.InsertRange(0, behind.Skip(1).Reverse().Select(piece => new ContourPiece(piece.Row, !piece.Reversed)));
            }

            yield return string.Join(' ', ahead);
        }
    }

    private static bool Grow(Segment[] segments, bool[] used, List<ContourPiece> pieces, int first, double tolerance)
    {
        var length = segments[pieces[0].Row].Length;
        while (true)
        {
            var (here, travel) = (Place(segments, End(pieces[^1])), -Into(segments, End(pieces[^1])));
            var mayClose = length > 2.0 * tolerance || here.DistanceTo(Place(segments, End(pieces[0]) ^ 1)) <= SmallGap * length;
            var near = Enumerable.Range(0, 2 * segments.Length)
                .Where(end => (!used[end / 2] || (mayClose && first >= 0 && end == 2 * first)) && Place(segments, end).IsNear(here, tolerance)).ToArray();
            if (near.Length == 0) return false;
            var chosen = Chosen(segments, near, here, travel, tolerance);
            if (chosen / 2 == first) return true;
            used[chosen / 2] = true;
            pieces.Add(new ContourPiece(chosen / 2, Reversed: chosen % 2 == 1));
            length += segments[chosen / 2].Length;
        }
    }

    /// <summary>The nearest of those no longer than the tolerance; otherwise the straightest, of equals the lowest row, and of its two ends the
    /// nearer.</summary>
    private static int Chosen(Segment[] segments, int[] near, Point2D here, Vector2D travel, double tolerance)
    {
        var tiny = near.Where(end => segments[end / 2].Length <= tolerance).ToArray();
        if (tiny.Length > 0) return tiny.OrderBy(end => here.DistanceTo(Place(segments, end))).ThenBy(end => end).First();
        if (near.All(end => end / 2 == near[0] / 2)) return near.OrderBy(end => here.DistanceTo(Place(segments, end))).ThenBy(end => end).First();
        var best = near.Max(end => travel.Dot(Into(segments, end)));
        return near.Where(end => travel.Dot(Into(segments, end)) >= best - SameTurn).OrderBy(end => end / 2).ThenBy(end => here.DistanceTo(Place(segments, end))).ThenBy(end => end).First();
    }

    /// <summary>The number of the end of a piece: 2 x row is a segment's start, 2 x row + 1 its end.</summary>
    private static int End(ContourPiece piece) => (2 * piece.Row) + (piece.Reversed ? 0 : 1);

    private static Point2D Place(Segment[] segments, int end) => end % 2 == 0 ? segments[end / 2].Start : segments[end / 2].End;

    private static Vector2D Into(Segment[] segments, int end) => end % 2 == 0 ? segments[end / 2].StartTangent : -segments[end / 2].EndTangent;
}
