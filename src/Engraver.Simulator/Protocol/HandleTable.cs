namespace Engraver.Simulator.Protocol;

/// <summary>The controller's connections, A to H (galil-dmc.md A.1).</summary>
internal sealed class HandleTable(int capacity)
{
    private readonly Handle?[] _handles = new Handle?[capacity];

    private int _lost;

    public int Capacity => _handles.Length;

    public Handle? this[int index] => _handles[index];

    public int Free => _handles.AsSpan().Count((Handle?)null);

    /// <summary>The handle lost last, -1 when there is none: <c>_IA4</c>.</summary>
    public int LostLast { get; private set; } = -1;

    public IEnumerable<Handle> Open => _handles.OfType<Handle>();

    /// <summary>True once for a handle whose client has disconnected without the controller detecting it.</summary>
    public bool NoticeLoss(int index)
    {
        var lost = (_lost & (1 << index)) != 0;
        _lost &= ~(1 << index);
        return lost;
    }

    /// <summary>Puts a new handle into the first free place; returns null when all places are in use.</summary>
    public Handle? TryOpen(Func<int, Handle> create)
    {
        var index = Array.IndexOf(_handles, null);
        return index < 0 ? null : _handles[index] = create(index);
    }

    public void Remove(Handle handle)
    {
        if (_handles[handle.Index] == handle)
        {
            _handles[handle.Index] = null;
            LostLast = handle.Index;
            _lost |= 1 << handle.Index;
        }
    }
}
