namespace Engraver.Simulator.Protocol;

/// <summary>Replies that a fault plan delays, in the order in which they were given.</summary>
/// <param name="usual">By how much every reply is late.</param>
internal sealed class DelayedReplies(TimeProvider time, TimeSpan usual)
{
    private readonly Queue<(long Due, Handle Handle, byte[] Bytes)> _waiting = new();

    public bool AreWaiting => _waiting.Count > 0;

    /// <param name="more">By how much this reply is late besides; later ones do not overtake it.</param>
    public void Send(Handle handle, ReadOnlySpan<byte> bytes, TimeSpan more)
    {
        var delay = usual + more;
        if (delay <= TimeSpan.Zero && !AreWaiting)
        {
            handle.Emit(bytes);
            return;
        }

        var ticks = (long)(delay.TotalSeconds * time.TimestampFrequency);
        _waiting.Enqueue((time.GetTimestamp() + ticks, handle, bytes.ToArray()));
    }

    /// <summary>Sends the replies that are due.</summary>
    public void Release()
    {
        while (_waiting.TryPeek(out var next) && time.GetTimestamp() >= next.Due)
        {
            _waiting.Dequeue();
            next.Handle.Emit(next.Bytes);
        }
    }
}
