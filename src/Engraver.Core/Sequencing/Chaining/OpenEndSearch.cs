using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Finds the ends of open contours and, for each, the nearest other one.</summary>
internal static class OpenEndSearch
{
    public static IReadOnlyList<Discontinuity> Find(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, EndHeights heights)
    {
        var count = 2 * contours.Count(contour => !contour.Closed);
        var (places, rows, levels) = (new Point2D[count], new int[count], new double[heights.AreFlat ? 0 : count]);
        var end = 0;
        foreach (var contour in contours)
        {
            if (contour.Closed) continue;
            var pieces = contour.Pieces.Span;
            (places[end], rows[end]) = (pieces[0].StartIn(segments), pieces[0].Row);
            (places[end + 1], rows[end + 1]) = (pieces[^1].EndIn(segments), pieces[^1].Row);
            if (levels.Length > 0) (levels[end], levels[end + 1]) = (heights.HeightOf(pieces[0].StartNumber), heights.HeightOf(pieces[^1].EndNumber));
            end += 2;
        }

        return levels.Length == 0 && PlaceGrid.TryBuild(places) is { } grid ? MeasureFlat(grid, places, rows) : Measure(places, rows, levels);
    }

    private static Discontinuity[] MeasureFlat(PlaceGrid grid, Point2D[] places, int[] rows)
    {
        var ends = new Discontinuity[places.Length];
        foreach (var i in grid.ByCell())
        {
            var other = grid.Nearest(places[i], i, out var gap);
            ends[i] = new Discontinuity(places[i], rows[i], other < 0 ? null : gap, other < 0 ? -1 : rows[other]);
        }

        return ends;
    }

    /// <param name="levels">Heights of the ends; empty where all are at one.</param>
    private static Discontinuity[] Measure(Point2D[] places, int[] rows, double[] levels)
    {
        var tree = BoxTree.Build(places);
        var ends = new Discontinuity[places.Length];
        foreach (var i in tree.AlongCurve)
        {
            tree.Hide(i);
            var other = tree.Nearest(places[i], (end, place) => levels.Length == 0 ? places[end].DistanceTo(place) : double.Hypot(places[end].DistanceTo(place), levels[end] - levels[i]), double.PositiveInfinity, out var gap);
            tree.Show(i);
            ends[i] = new Discontinuity(places[i], rows[i], other < 0 ? null : gap, other < 0 ? -1 : rows[other]);
        }

        return ends;
    }
}

/// <summary>A contour end with no partner within the join tolerance.</summary>
public readonly record struct Discontinuity
{
    private readonly double _gap;

    /// <param name="place">Position, millimetres.</param>
    /// <param name="row">The row that ends here.</param>
    /// <param name="gap">Distance to the nearest other open end; null when there is no other.</param>
    /// <param name="nearestRow">The row of that other end; -1 without one.</param>
    public Discontinuity(Point2D place, int row, double? gap, int nearestRow) => (Place, Row, _gap, NearestRow) = (place, row, gap ?? double.NaN, nearestRow);

    /// <summary>Position, millimetres.</summary>
    public Point2D Place { get; }

    /// <summary>The row that ends here.</summary>
    public int Row { get; }

    /// <summary>Distance to the nearest other open end (it may be the other end of the same contour); null when there is no other.</summary>
    public double? Gap => double.IsNaN(_gap) ? null : _gap;

    /// <summary>The row of that other end; -1 without one.</summary>
    public int NearestRow { get; }
}
