using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>Points where very many segments meet (the centre of a sunburst, a star smaller than the tolerance): the ends in such a square of the grid are put
/// into trees, so that finding the next end takes logarithmic time instead of a test of each end.</summary>
internal sealed class CrowdedJunctions(EndGrid ends, Point2D[] places, double tolerance)
{
    /// <summary>Up to this number of ends around one point, each is tested.</summary>
    public const int Crowd = 128;

    /// <summary>Allowance for rounding, as a part of the tolerance; <see cref="Point2D.IsNear"/> finally decides whether an end is near.</summary>
    private const double Rounding = 1e-9;

    private readonly Dictionary<((long X, long Y) Cell, int Level), Junction> _junctions = [];
    private readonly List<int> _setAside = [];
    private long _comparisons;

    /// <summary>Number of ends and boxes that were tested.</summary>
    public long Comparisons => _comparisons + _junctions.Values.Sum(junction => junction.Others.Comparisons);

    /// <summary>The junctions that can have ends near a point.</summary>
    /// <param name="here">Present end of the contour.</param>
    /// <param name="level">Height level of that end.</param>
    /// <param name="isAtLevel">True for the ends at that level.</param>
    /// <param name="isShort">True for the ends of segments shorter than the tolerance.</param>
    /// <param name="travelInto">Direction in which a segment is entered at an end, length 1.</param>
    public Junction[] Near(Point2D here, int level, Predicate<int> isAtLevel, Predicate<int> isShort, Func<int, Vector2D> travelInto)
    {
        var found = new List<Junction>();
        foreach (var cell in ends.CellsNear(here).ToArray().OrderByDescending(cell => cell == ends.CellAt(here))) // the nearest end is usually in the same square, and then other squares need not be searched
        {
            if (!_junctions.TryGetValue((cell, level), out var junction))
            {
                var all = ends.PlacesIn(cell).Where(end => isAtLevel(end)).ToLookup(end => isShort(end));
                int[] shorts = [.. all[true]];
                junction = new Junction(shorts, BoxTree.Build([.. shorts.Select(end => places[end])]), DirectionTree.Build([.. all[false]], places, tolerance, travelInto));
                _junctions.Add((cell, level), junction);
            }

            found.Add(junction);
        }

        return [.. found];
    }

    /// <summary>The nearest end of a short segment within the tolerance, the lower number in case of a tie; null when there is none.</summary>
    public int? NearestShort(Junction[] junctions, Point2D here, Predicate<int> counts)
    {
        int? best = null;
        var within = tolerance * (1.0 + Rounding);
        foreach (var junction in junctions)
        {
            if (NearestShort(junction, here, within, counts) is not { } end) continue;
            var distance = here.DistanceTo(places[end]);
            if (best is null || distance < within || end < best) best = end;
            within = distance;
        }

        return best;
    }

    private int? NearestShort(Junction junction, Point2D here, double within, Predicate<int> counts)
    {
        var item = Nearest(junction, here, within);
        while (item >= 0 && (ends.IsTaken(junction.Shorts[item]) || !counts(junction.Shorts[item])))
        {
            junction.ShortPlaces.Hide(item);
            if (!ends.IsTaken(junction.Shorts[item])) _setAside.Add(item); // not taken: the first segment of the contour, whose end can close it later
            item = Nearest(junction, here, within);
        }

        foreach (var hidden in _setAside) junction.ShortPlaces.Show(hidden);
        _setAside.Clear();
        return item >= 0 && places[junction.Shorts[item]].IsNear(here, tolerance) ? junction.Shorts[item] : null;
    }

    private int Nearest(Junction junction, Point2D here, double within) => junction.ShortPlaces.Nearest(here, (item, place) => Distance(junction.Shorts[item], place), within, out _);

    private double Distance(int end, Point2D place)
    {
        _comparisons++;
        return places[end].DistanceTo(place);
    }

    /// <summary>True when there is any end within the tolerance for which <paramref name="counts"/> holds.</summary>
    public bool IsAny(Junction[] junctions, Point2D here, Predicate<int> counts) =>
        NearestShort(junctions, here, counts) is not null || Straightest(junctions, here, default, 0.0, counts) is not null;

    /// <summary>The end within the tolerance with the straightest continuation; of equal ends the one with the lowest number; null when there is
    /// none.</summary>
    /// <param name="junctions">The result of <see cref="Near"/>.</param>
    /// <param name="here">Present end of the contour.</param>
    /// <param name="travel">Direction of travel, length 1.</param>
    /// <param name="sameTurnCosine">Directions whose cosines differ by less are equally straight.</param>
    /// <param name="counts">True for the ends that may be chosen.</param>
    /// <returns>The end, and the cosine of the straightest.</returns>
    public (int End, double Cosine)? Straightest(Junction[] junctions, Point2D here, Vector2D travel, double sameTurnCosine, Predicate<int> counts)
    {
        var query = new DirectionTree.Query(here, tolerance, travel, end => !ends.IsTaken(end) && counts(end), ends.IsTaken);
        var straightest = double.NegativeInfinity;
        foreach (var junction in junctions) straightest = junction.Others.Straightest(query, straightest);
        if (double.IsNegativeInfinity(straightest)) return null;
        var lowest = int.MaxValue;
        foreach (var junction in junctions) lowest = junction.Others.Lowest(query, straightest - sameTurnCosine, lowest);
        return (lowest, straightest);
    }

    /// <summary>The ends of one square at one height level.</summary>
    /// <param name="Shorts">Ends of segments shorter than the tolerance, ascending.</param>
    /// <param name="ShortPlaces">Their positions.</param>
    /// <param name="Others">The ends of all other segments.</param>
    public sealed record Junction(int[] Shorts, BoxTree ShortPlaces, DirectionTree Others);
}
