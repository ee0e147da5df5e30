using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Finds the ends of open contours and, for each, the nearest other one.</summary>
internal static class OpenEndSearch
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
        var tree = BoxTree.Build(places);
        var ends = new Discontinuity[places.Length];
        foreach (var i in tree.AlongCurve)
        {
            tree.Hide(i);
            var other = tree.Nearest(places[i], (end, place) => double.Hypot(places[end].DistanceTo(place), levels[end] - levels[i]), double.PositiveInfinity, out var gap);
            tree.Show(i);
            ends[i] = new Discontinuity(places[i], rows[i], other < 0 ? null : gap, other < 0 ? -1 : rows[other]);
        }

        return ends;
    }
}

/// <summary>A contour end with no partner within the join tolerance.</summary>
/// <param name="Place">Position, millimetres.</param>
/// <param name="Row">The row that ends here.</param>
/// <param name="Gap">Distance to the nearest other open end (it may be the other end of the same contour); null when there is no other.</param>
/// <param name="NearestRow">The row of that other end; -1 without one.</param>
public readonly record struct Discontinuity(Point2D Place, int Row, double? Gap, int NearestRow);
