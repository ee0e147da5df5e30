namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Nodes that wait for an improvement, each once, first in first out.</summary>
internal sealed class NodeQueue(int count)
{
    private readonly int[] _nodes = new int[count];
    private readonly bool[] _isWaiting = new bool[count];
    private int _first;
    private int _waiting;

    public void Add(int node)
    {
        if (_isWaiting[node]) return;
        _isWaiting[node] = true;
        var end = _first + _waiting++;
        _nodes[end >= _nodes.Length ? end - _nodes.Length : end] = node;
    }

    public void Add(int a, int b, int c, int d)
    {
        Add(a);
        Add(b);
        Add(c);
        Add(d);
    }

    public bool TryTake(out int node)
    {
        node = -1;
        if (_waiting == 0) return false;
        node = _nodes[_first];
        _isWaiting[node] = false;
        if (++_first == _nodes.Length) _first = 0;
        _waiting--;
        return true;
    }

    public void Clear()
    {
        while (TryTake(out _))
        {
        }
    }
}
