using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Places that the operator picked on the drawing, each with the closed stroke that is nearest to it.</summary>
internal sealed class PickedPlaces
{
    private readonly ILookup<int, Point2D> _places;

    /// <param name="strokes">The segments of each stroke; none for a stroke that takes no place.</param>
    /// <param name="places">Millimetres.</param>
    /// <param name="within">Largest distance of a place from its stroke, mm.</param>
    public PickedPlaces(IReadOnlyList<IReadOnlyList<Segment>> strokes, IReadOnlyList<Point2D> places, double within)
    {
        _places = places.ToLookup(place => NearestOf(strokes, place, within));
        Unused = [.. _places[-1]];
    }

    /// <summary>Places that are near no stroke.</summary>
    public IReadOnlyList<Point2D> Unused { get; }

    /// <summary>The places of a stroke, in the order of picking.</summary>
    public IEnumerable<Point2D> Of(int stroke) => _places[stroke];

    private static int NearestOf(IReadOnlyList<IReadOnlyList<Segment>> strokes, Point2D place, double within)
    {
        var (nearest, least) = (-1, double.PositiveInfinity);
        for (var stroke = 0; stroke < strokes.Count; stroke++)
        {
            var distance = strokes[stroke].Select(segment => segment.DistanceTo(place)).DefaultIfEmpty(double.PositiveInfinity).Min();
            if (distance <= within && distance < least) (nearest, least) = (stroke, distance);
        }

        return nearest;
    }
}
