namespace Engraver.Simulator.Protocol;

/// <summary>Replies that a fault plan delays, in the order in which they were created.</summary>
/// <param name="usual">Delay of every reply.</param>
internal sealed class DelayedReplies(TimeProvider time, TimeSpan usual)
{
    private readonly Queue<(long Due, Handle Handle, byte[] Bytes)> _waiting = new();

    public bool AreWaiting => _waiting.Count > 0;

    /// <param name="more">Additional delay of this reply; later replies do not overtake it.</param>
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
