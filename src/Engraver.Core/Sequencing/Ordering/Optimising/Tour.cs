namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>An order of the nodes as a closed tour through the tool, with their entries. Changes are logged and can be undone.</summary>
/// <remarks>Without constraints a tour is the same in both directions, so the shorter part is reversed; with constraints never the part with the
/// tool.</remarks>
internal sealed class Tour
{
    private readonly OrderProblem _problem;
    private readonly bool _isConstrained;
    private readonly int[] _order;
    private readonly int[] _positions;
    private readonly int[] _entries;
    private readonly NodeEnds[] _ends;
    private readonly bool[] _isOpen;
    private readonly List<(int First, int Second, LogKind Kind)> _log = [];

    /// <summary>The nodes before each arrangement.</summary>
    private readonly List<int[]> _arranged = [];

    public Tour(OrderProblem problem)
    {
        (_problem, _isConstrained) = (problem, problem.IsConstrained);
        _order = [.. Enumerable.Range(0, problem.Count)];
        _positions = [.. _order];
        _entries = [.. _order.Select(problem.FirstEntryOf)];
        _ends = [.. _order.Select(node => problem.EndsOf(node, _entries[node]))];
        _isOpen = [.. _order.Select(node => problem.KindOf(node) != NodeKind.Closed)];
    }

    public int Count => _order.Length;

    /// <summary>Ends of each node in the present direction.</summary>
    public NodeEnds[] Ends => _ends;

    public int At(int position) => _order[position];

    public int PositionOf(int node) => _positions[node];

    public int EntryOf(int node) => _entries[node];

    /// <summary>The entry of a node when the tour is read in the other direction.</summary>
    public int TurnedEntryOf(int node) => _isOpen[node] ? 1 - _entries[node] : _entries[node];

    public int Next(int node)
    {
        var position = _positions[node] + 1;
        return _order[position == _order.Length ? 0 : position];
    }

    public int Previous(int node)
    {
        var position = _positions[node];
        return _order[(position == 0 ? _order.Length : position) - 1];
    }

    /// <summary>Number of steps from one node forwards to another.</summary>
    public int StepsBetween(int from, int to)
    {
        var steps = _positions[to] - _positions[from];
        return steps < 0 ? steps + _order.Length : steps;
    }

    /// <summary>Replaces the links a-b and c-d by a-c and b-d.</summary>
    /// <remarks>Either b follows a and d follows c, or a follows b and c follows d.</remarks>
    public void Exchange(int a, int b, int c, int d)
    {
        if (Next(a) == b) ReverseFrom(b, c, d, a);
        else ReverseFrom(c, b, a, d);
    }

    /// <summary>Moves the nodes from <paramref name="first"/> to <paramref name="last"/> between two others.</summary>
    /// <param name="after">The node behind which they are put; outside them.</param>
    public void Move(int first, int last, int after, bool isTurned)
    {
        var (previous, next, before) = (Previous(first), Next(last), Next(after));
        Exchange(previous, first, after, before);
        Exchange(previous, after, next, last);
        if (!isTurned) Exchange(after, last, first, before);
    }

    /// <summary>Exchanges the nodes behind a up to d with the nodes behind d up to e.</summary>
    public void Swap(int a, int d, int e)
    {
        var (b, c, f) = (Next(a), Next(d), Next(e));
        Exchange(a, b, e, f);
        Exchange(a, e, c, d);
        Exchange(e, d, b, f);
    }

    /// <summary>Puts nodes in another order.</summary>
    /// <param name="first">The first of their positions.</param>
    /// <param name="nodes">The nodes of these positions in the new order.</param>
    /// <param name="isTurned">They are turned too, except those with one direction.</param>
    public void Arrange(int first, IReadOnlyList<int> nodes, bool isTurned)
    {
        var before = _order[first..(first + nodes.Count)];
        _log.Add((first, _arranged.Count, isTurned ? LogKind.ArrangeTurned : LogKind.Arrange));
        _arranged.Add(before);
        Place(first, nodes, isTurned);
    }

    private void Place(int first, IReadOnlyList<int> nodes, bool isTurned)
    {
        for (var i = 0; i < nodes.Count; i++)
        {
            var node = nodes[i];
            (_order[first + i], _positions[node]) = (node, first + i);
            if (isTurned && _problem.KindOf(node) == NodeKind.Open) Turn(node);
        }
    }

    public void SetEntry(int node, int entry)
    {
        if (_entries[node] == entry) return;
        _log.Add((node, _entries[node], LogKind.Entry));
        ChangeEntry(node, entry);
    }

    /// <summary>The present order and entries.</summary>
    public (int[] Order, int[] Entries) Copy() => ([.. _order], [.. _entries]);

    /// <summary>Returns to a copy.</summary>
    public void Restore((int[] Order, int[] Entries) copy)
    {
        Keep();
        for (var position = 0; position < _order.Length; position++)
        {
            var node = copy.Order[position];
            (_order[position], _positions[node]) = (node, position);
            ChangeEntry(node, copy.Entries[node]);
        }
    }

    /// <summary>Accepts all changes.</summary>
    public void Keep()
    {
        _log.Clear();
        _arranged.Clear();
    }

    /// <summary>Withdraws all changes since <see cref="Keep"/>.</summary>
    public void Undo()
    {
        for (var i = _log.Count - 1; i >= 0; i--)
        {
            var (first, second, kind) = _log[i];
            if (kind == LogKind.Entry) ChangeEntry(first, second);
            else if (kind != LogKind.Reverse) Place(first, _arranged[second], kind == LogKind.ArrangeTurned);
            else ReverseNodes(first, Length(first, second));
        }

        Keep();
    }

    private void ChangeEntry(int node, int entry)
    {
        _entries[node] = entry;
        _ends[node] = _problem.EndsOf(node, entry);
    }

    /// <summary>Reverses the path from b to c, or the rest of the tour, from d to a.</summary>
    private void ReverseFrom(int b, int c, int d, int a)
    {
        var (first, last) = (_positions[b], _positions[c]);
        var isInner = _isConstrained ? first != 0 && first <= last : 2 * Length(first, last) <= _order.Length;
        if (!isInner) (first, last) = (_positions[d], _positions[a]);
        _log.Add((first, last, LogKind.Reverse));
        ReverseNodes(first, Length(first, last));
    }

    private int Length(int first, int last) => (last < first ? last + _order.Length : last) - first + 1;

    private void ReverseNodes(int first, int length)
    {
        var (order, positions, count) = (_order, _positions, _order.Length);
        var last = first + length - 1;
        if (last >= count) last -= count;
        for (var left = length / 2; left > 0; left--)
        {
            var (low, high) = (order[first], order[last]);
            (order[first], order[last]) = (high, low);
            (positions[high], positions[low]) = (first, last);
            if (_isOpen[low]) Turn(low);
            if (_isOpen[high]) Turn(high);
            if (++first == count) first = 0;
            if (--last < 0) last = count - 1;
        }

        if ((length & 1) == 1 && _isOpen[order[first]]) Turn(order[first]);
    }

    private void Turn(int node)
    {
        _entries[node] ^= 1;
        _ends[node] = _ends[node].Turned;
    }

    private enum LogKind : byte
    {
        Entry,
        Reverse,
        Arrange,
        ArrangeTurned,
    }
}
