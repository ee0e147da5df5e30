namespace Engraver.Core.Verification.Corners;

/// <summary>The drawn ends by place, without an object for each of them: a drawing can have millions.</summary>
internal sealed class EndGroups
{
    /// <summary>Distance of ends that are the same place, millimetres.</summary>
    private const double Same = 1e-6;

    /// <summary>Groups compared with one group at most: where more are this close together, the drawing is everywhere near.</summary>
    private const int MaxNear = 24;

    private const int None = -1;

    private readonly PieceEnd[] _ends;

    /// <summary>The next end of the same group.</summary>
    private readonly int[] _next;

    /// <summary>An end of each group.</summary>
    private readonly List<int> _heads = [];

    public EndGroups(PieceEnd[] ends)
    {
        (_ends, _next) = (ends, new int[ends.Length]);
        var groups = new Dictionary<(long X, long Y, long Z), int>(ends.Length / 2);
        for (var i = 0; i < ends.Length; i++)
        {
            var at = ((long)Math.Round(ends[i].Place.X / Same), (long)Math.Round(ends[i].Place.Y / Same), (long)Math.Round(ends[i].Z / Same));
            if (groups.TryGetValue(at, out var group)) (_next[i], _heads[group]) = (_heads[group], i);
            else (_next[i], groups[at]) = (None, _heads.Count);
            if (_next[i] == None) _heads.Add(i);
        }
    }

    /// <summary>The groups of more than one end.</summary>
    public IEnumerable<EndGroup> OfSeveral() => _heads.Where(head => _next[head] != None).Select(Of);

    /// <summary>Pairs of different groups, each once.</summary>
    /// <param name="within">Largest distance between the two groups of a pair, millimetres.</param>
    public IEnumerable<(EndGroup One, EndGroup Other)> Near(double within)
    {
        var cells = new Dictionary<(long X, long Y), int>(_heads.Count);
        var next = new int[_heads.Count];
        for (var i = 0; i < _heads.Count; i++)
        {
            var (x, y) = ((long)Math.Floor(_ends[_heads[i]].Place.X / within), (long)Math.Floor(_ends[_heads[i]].Place.Y / within));
            var near = 0;
            for (var column = x - 1; column <= x + 1; column++)
            {
                for (var row = y - 1; row <= y + 1; row++)
                {
                    for (var k = cells.GetValueOrDefault((column, row), None); k != None && near < MaxNear; k = next[k])
                    {
                        if (!AreNear(_ends[_heads[i]], _ends[_heads[k]], within)) continue;
                        near++;
                        yield return (Of(_heads[i]), Of(_heads[k]));
                    }
                }
            }

            (next[i], cells[(x, y)]) = (cells.GetValueOrDefault((x, y), None), i);
        }
    }

    private static bool AreNear(in PieceEnd one, in PieceEnd other, double within) =>
        one.Place.IsNear(other.Place, within) && Math.Abs(one.Z - other.Z) <= within;

    private EndGroup Of(int head)
    {
        var ends = new List<PieceEnd>();
        for (var i = head; i != None; i = _next[i]) ends.Add(_ends[i]);
        return EndGroup.Of(ends);
    }
}
