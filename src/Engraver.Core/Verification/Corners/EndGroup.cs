namespace Engraver.Core.Verification.Corners;

/// <summary>Drawn ends at one place, by direction.</summary>
/// <param name="Ends">In order of their direction, counter-clockwise.</param>
/// <param name="Angles">Their directions, radians from -pi to pi.</param>
internal sealed record EndGroup(PieceEnd[] Ends, double[] Angles)
{
    public static EndGroup Of(List<PieceEnd> ends)
    {
        double[] angles = [.. ends.Select(end => Math.Atan2(end.Along.Y, end.Along.X))];
        PieceEnd[] sorted = [.. ends];
        Array.Sort(angles, sorted);
        return new EndGroup(sorted, angles);
    }

    /// <summary>All ends by direction, from an angle on.</summary>
    /// <param name="angle">Radians.</param>
    /// <param name="isRising">True for increasing angles from the first above this one; false for decreasing ones from the first not above it.</param>
    public IEnumerable<PieceEnd> From(double angle, bool isRising)
    {
        var first = FirstAbove(Math.IEEERemainder(angle, 2.0 * Math.PI));
        for (var i = 0; i < Ends.Length; i++) yield return Ends[(first + (isRising ? i : -1 - i) + (2 * Ends.Length)) % Ends.Length];
    }

    /// <summary>The first end at a larger angle; the number of ends when there is none.</summary>
    private int FirstAbove(double angle)
    {
        var found = Array.BinarySearch(Angles, angle);
        if (found < 0) return ~found;
        while (found < Angles.Length && Angles[found] == angle) found++;
        return found;
    }
}
