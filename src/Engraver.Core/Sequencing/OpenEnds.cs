using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Finds the ends of open contours and, for each, the nearest other one.</summary>
internal static class OpenEnds
{
    public static IReadOnlyList<Discontinuity> Find(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, EndHeights heights)
    {
        var places = new List<Point2D>();
        var rows = new List<int>();
        var levels = new List<double>();
        foreach (var contour in contours)
        {
            if (contour.Closed) continue;
            places.Add(contour.StartIn(segments));
            rows.Add(contour.Pieces.Span[0].Row);
            levels.Add(heights.HeightOf(contour.Pieces.Span[0].StartNumber));
            places.Add(contour.EndIn(segments));
            rows.Add(contour.Pieces.Span[^1].Row);
            levels.Add(heights.HeightOf(contour.Pieces.Span[^1].EndNumber));
        }

        return Measure([.. places], rows, levels);
    }

    private static Discontinuity[] Measure(Point2D[] places, List<int> rows, List<double> levels)
    {
        var tree = BoxTree.Of(places);
        var ends = new Discontinuity[places.Length];
        for (var i = 0; i < ends.Length; i++)
        {
            tree.Hide(i);
            var other = tree.Nearest(places[i], (end, place) => double.Hypot(places[end].DistanceTo(place), levels[end] - levels[i]), double.PositiveInfinity, out var gap);
            tree.Show(i);
            ends[i] = new Discontinuity(places[i], rows[i], other < 0 ? null : gap, other < 0 ? -1 : rows[other]);
        }

        return ends;
    }
}
