using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Places that are not nearer to each other than a tolerance.</summary>
/// <param name="tolerance">Millimetres, above 0.</param>
internal sealed class DistinctPlaces(double tolerance)
{
    private readonly Dictionary<(long X, long Y), List<Point2D>> _cells = [];

    /// <summary>Adds a place; false when it is nearer than the tolerance to one that was added before.</summary>
    public bool Add(Point2D place)
    {
        var (x, y) = ((long)Math.Floor(place.X / tolerance), (long)Math.Floor(place.Y / tolerance));
        for (var i = x - 1; i <= x + 1; i++)
        {
            for (var j = y - 1; j <= y + 1; j++)
            {
                if (_cells.TryGetValue((i, j), out var near) && near.Exists(other => other.DistanceTo(place) < tolerance)) return false;
            }
        }

        if (!_cells.TryGetValue((x, y), out var cell)) _cells[(x, y)] = cell = [];
        cell.Add(place);
        return true;
    }
}
