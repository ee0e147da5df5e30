namespace Engraver.Core.Machines;

/// <summary>Part of a segment that cuts one entity of several.</summary>
/// <param name="EntityIndex">The drawing entity.</param>
/// <param name="Length">Path length of the part, counts.</param>
public readonly record struct EntityShare(int EntityIndex, double Length)
{
    /// <summary>Lengths below this are not a part, counts.</summary>
    private const double Nothing = 1e-3;

    /// <summary>The shares of a piece of a segment.</summary>
    /// <param name="shares">Of the segment; null where it has one entity.</param>
    /// <param name="from">Length at which the piece begins, counts.</param>
    /// <param name="to">Length at which it ends; the last share continues to there.</param>
    /// <returns>At least one, where the segment has shares.</returns>
    public static IReadOnlyList<EntityShare>? Between(IReadOnlyList<EntityShare>? shares, double from, double to)
    {
        if (shares is null) return null;
        var (found, start) = (new List<EntityShare>(), 0.0);
        for (var i = 0; i < shares.Count; i++)
        {
            var end = i == shares.Count - 1 ? Math.Max(to, start) : start + shares[i].Length;
            var length = Math.Min(end, to) - Math.Max(start, from);
            if (length > Nothing || (found.Count == 0 && i == shares.Count - 1)) found.Add(new EntityShare(shares[i].EntityIndex, Math.Max(0.0, length)));
            start = end;
        }

        return found;
    }
}
