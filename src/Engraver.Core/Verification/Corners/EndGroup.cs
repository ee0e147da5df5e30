using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>Drawn ends at one place, by direction.</summary>
/// <param name="Ends">In order of their direction, counter-clockwise.</param>
/// <param name="Angles">Their directions, radians from -pi to pi.</param>
internal sealed record EndGroup(PieceEnd[] Ends, double[] Angles)
{
    /// <summary>Distance of ends that are the same place, millimetres.</summary>
    private const double Same = 1e-6;

    /// <summary>Groups compared with one group at most: where more are this close together, the drawing is everywhere near.</summary>
    private const int MaxNear = 24;

    public Point2D Place => Ends[0].Place;

    public static List<EndGroup> AllOf(PieceEnd[] all)
    {
        var groups = new Dictionary<(long X, long Y, long Z), List<PieceEnd>>();
        foreach (var end in all)
        {
            var at = ((long)Math.Round(end.Place.X / Same), (long)Math.Round(end.Place.Y / Same), (long)Math.Round(end.Z / Same));
            if (!groups.TryGetValue(at, out var ends)) groups[at] = ends = [];
            ends.Add(end);
        }

        return [.. groups.Values.Select(Of)];
    }

    /// <summary>Pairs of different groups, each once.</summary>
    /// <param name="within">Largest distance between the two groups of a pair, millimetres.</param>
    public static IEnumerable<(EndGroup One, EndGroup Other)> Near(List<EndGroup> groups, double within)
    {
        var cells = new Dictionary<(long X, long Y), List<int>>();
        for (var i = 0; i < groups.Count; i++)
        {
            var (x, y) = Cell(groups[i]);
            var near = 0;
            for (var column = x - 1; column <= x + 1; column++)
            {
                for (var row = y - 1; row <= y + 1; row++)
                {
                    if (!cells.TryGetValue((column, row), out var others)) continue;
                    for (var k = others.Count - 1; k >= 0 && near < MaxNear; k--)
                    {
                        if (!groups[others[k]].IsNear(groups[i], within)) continue;
                        near++;
                        yield return (groups[i], groups[others[k]]);
                    }
                }
            }

            if (!cells.TryGetValue((x, y), out var own)) cells[(x, y)] = own = [];
            own.Add(i);
        }

        (long X, long Y) Cell(EndGroup group) => ((long)Math.Floor(group.Place.X / within), (long)Math.Floor(group.Place.Y / within));
    }

    /// <summary>All ends by direction, from an angle on.</summary>
    /// <param name="angle">Radians.</param>
    /// <param name="isRising">True for increasing angles from the first above this one; false for decreasing ones from the first not above it.</param>
    public IEnumerable<PieceEnd> From(double angle, bool isRising)
    {
        var first = FirstAbove(Math.IEEERemainder(angle, 2.0 * Math.PI));
        for (var i = 0; i < Ends.Length; i++) yield return Ends[(first + (isRising ? i : -1 - i) + (2 * Ends.Length)) % Ends.Length];
    }

    private bool IsNear(EndGroup other, double within) => Place.IsNear(other.Place, within) && Math.Abs(Ends[0].Z - other.Ends[0].Z) <= within;

    /// <summary>The first end at a larger angle; the number of ends when there is none.</summary>
    private int FirstAbove(double angle)
    {
        var found = Array.BinarySearch(Angles, angle);
        if (found < 0) return ~found;
        while (found < Angles.Length && Angles[found] == angle) found++;
        return found;
    }

    private static EndGroup Of(List<PieceEnd> ends)
    {
        double[] angles = [.. ends.Select(end => Math.Atan2(end.Along.Y, end.Along.X))];
        PieceEnd[] sorted = [.. ends];
        Array.Sort(angles, sorted);
        return new EndGroup(sorted, angles);
    }
}
