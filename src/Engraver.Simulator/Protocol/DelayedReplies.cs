namespace Engraver.Simulator.Protocol;

/// <summary>Replies that a fault plan delays, in the order in which they were given.</summary>
internal sealed class DelayedReplies(TimeProvider time, TimeSpan delay)
{
    private readonly Queue<(long Due, Handle Handle, byte[] Bytes)> _waiting = new();

    public bool AreWaiting => _waiting.Count > 0;

    public void Send(Handle handle, ReadOnlySpan<byte> bytes)
    {
        if (delay <= TimeSpan.Zero)
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
