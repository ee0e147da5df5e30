namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>The nearest different nodes found so far, nearest first.</summary>
/// <param name="capacity">Largest number of nodes.</param>
internal sealed class NearList(int capacity)
{
    private readonly (double Squared, int Node, double Dx, double Dy)[] _items = new (double, int, double, double)[capacity];
    private int _self;

    public int Count { get; private set; }

    /// <summary>Square of the distance within which a node is entered, mm2.</summary>
    public double Reach => Count < capacity ? double.PositiveInfinity : _items[Count - 1].Squared;

    /// <summary>Node and distance in X and Y of its nearest place.</summary>
    public (int Node, double Dx, double Dy) this[int index] => (_items[index].Node, _items[index].Dx, _items[index].Dy);

    /// <param name="self">The node that is not entered.</param>
    public void Clear(int self) => (_self, Count) = (self, 0);

    public void Offer(int node, double dx, double dy)
    {
        var squared = (dx * dx) + (dy * dy);
        if (squared >= Reach || node == _self) return;
        var at = 0;
        while (at < Count && _items[at].Node != node) at++;
        if (at < Count && _items[at].Squared <= squared) return;
        if (at == Count && Count < capacity) Count++;
        at = Math.Min(at, Count - 1);
        for (; at > 0 && _items[at - 1].Squared > squared; at--) _items[at] = _items[at - 1];
        _items[at] = (squared, node, dx, dy);
    }
}
