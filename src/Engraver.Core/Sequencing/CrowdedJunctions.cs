using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Places where very many segments meet (the middle of a sunburst): their directions stand in a tree, so that finding the straightest takes a logarithm and not a look at each.</summary>
/// <remarks>Only for walks that arrive exactly at the place the crowd was found at, and only for crowds without segments shorter than the tolerance.</remarks>
internal sealed class CrowdedJunctions
{
    /// <summary>Fewer ends than this are looked at one by one.</summary>
    public const int Crowd = 64;

    private readonly Dictionary<(Point2D Place, int Level), (int[] Ends, Point2D[] Directions, BoxTree Tree)> _crowds = [];
    private readonly List<int> _found = [];

    public void Remember(Point2D here, int level, List<int> ends, Func<int, Vector2D> travelInto)
    {
        var directions = ends.Select(end => Point2D.Origin + travelInto(end)).ToArray();
        _crowds[(here, level)] = ([.. ends], directions, BoxTree.Of(directions));
    }

    /// <summary>Fills <paramref name="near"/> with the ends that lead on as straight as any, to rounding; false when no crowd is known here.</summary>
    /// <param name="here">Where the walk stands.</param>
    /// <param name="level">At which height (a level of the ends).</param>
    /// <param name="travel">Direction of travel, length 1.</param>
    /// <param name="sameTurnCosine">Directions whose cosines differ by less are equally straight.</param>
    /// <param name="isGone">True for ends that can never be chosen again.</param>
    /// <param name="near">Replaced by the answer; empty when nobody is left.</param>
    public bool TryFind(Point2D here, int level, Vector2D travel, double sameTurnCosine, Predicate<int> isGone, List<int> near)
    {
        if (_crowds.Count == 0 || !_crowds.TryGetValue((here, level), out var crowd)) return false;
        var ahead = Point2D.Origin + travel;
        near.Clear();
        while (crowd.Tree.Nearest(ahead, (item, place) => crowd.Directions[item].DistanceTo(place), double.PositiveInfinity, out var distance) is >= 0 and var nearest)
        {
            if (isGone(crowd.Ends[nearest]))
            {
                crowd.Tree.Hide(nearest);
                continue;
            }

            _found.Clear();
            crowd.Tree.Overlapping(Bounds2D.Of(ahead, ahead).Grown(Math.Sqrt((distance * distance) + (2.0 * sameTurnCosine))), _found); // |u - v|^2 = 2 - 2 cos
            foreach (var item in _found)
            {
                if (!isGone(crowd.Ends[item])) near.Add(crowd.Ends[item]);
            }

            break;
        }

        return true;
    }
}
