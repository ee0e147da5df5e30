namespace Engraver.Simulator.Protocol;

/// <summary>Replies that a fault plan makes late, in the order they were given.</summary>
internal sealed class DelayedReplies(TimeProvider time, TimeSpan delay)
{
    private readonly Queue<(long Due, Handle Handle, byte[] Bytes)> waiting = new();

    public void Send(Handle handle, ReadOnlySpan<byte> bytes)
    {
        if (delay <= TimeSpan.Zero)
        {
            handle.Output.Write(bytes);
            return;
        }

        long ticks = (long)(delay.TotalSeconds * time.TimestampFrequency);
        waiting.Enqueue((time.GetTimestamp() + ticks, handle, bytes.ToArray()));
    }

    /// <summary>Lets go what is due.</summary>
    public void Release()
    {
        while (waiting.TryPeek(out var next) && time.GetTimestamp() >= next.Due)
        {
            waiting.Dequeue();
            next.Handle.Output.Write(next.Bytes);
        }
    }
}
