namespace Engraver.Core.Verification;

/// <summary>Parameter intervals of one segment that have been covered. All are kept, however short: where a cut briefly follows another segment, a neighbour
/// may need it. Cuts that only cross are not added, so their number is small.</summary>
internal sealed class CoveredParts
{
    private const double Touching = 1e-9;
    private const int ManyParts = 64;
    private List<(double From, double To)>? _parts;
    private double _from = double.NaN;
    private double _to = double.NaN;

    public void Add(double from, double to)
    {
        (from, to) = (Math.Max(0.0, from), Math.Min(1.0, to));
        if (!(from <= to)) return;
        if (from <= _to + Touching && to >= _from - Touching)
        {
            (_from, _to) = (Math.Min(_from, from), Math.Max(_to, to));
            return;
        }

        Keep();
        (_from, _to) = (from, to);
    }

    /// <summary>Covered intervals, in order, none touching the next.</summary>
    public IReadOnlyList<(double From, double To)> Parts()
    {
        var parts = new List<(double From, double To)>(_parts ?? []);
        if (!double.IsNaN(_from)) parts.Add((_from, _to));
        if (parts.Count > 1) Merge(parts);
        return parts;
    }

    /// <summary>Uncovered intervals, in order.</summary>
    public IEnumerable<(double From, double To)> Gaps()
    {
        var end = 0.0;
        foreach (var (from, to) in Parts())
        {
            if (from > end + Touching) yield return (end, from);
            end = to;
        }

        if (end < 1.0 - Touching) yield return (end, 1.0);
    }

    private void Keep()
    {
        if (double.IsNaN(_from)) return;
        _parts ??= [];
        _parts.Add((_from, _to));
        if (_parts.Count >= ManyParts && (_parts.Count & (_parts.Count - 1)) == 0) Merge(_parts);
    }

    private static void Merge(List<(double From, double To)> parts)
    {
        parts.Sort();
        var kept = 0;
        for (var i = 1; i < parts.Count; i++)
        {
            if (parts[i].From <= parts[kept].To + Touching) parts[kept] = (parts[kept].From, Math.Max(parts[kept].To, parts[i].To));
            else parts[++kept] = parts[i];
        }

        parts.RemoveRange(kept + 1, parts.Count - kept - 1);
    }
}
