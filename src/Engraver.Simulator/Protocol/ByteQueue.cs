namespace Engraver.Simulator.Protocol;

/// <summary>Bytes on their way to one reader. Writing never waits; reading completes at once while bytes are there.</summary>
internal sealed class ByteQueue
{
    private readonly Lock gate = new();
    private byte[] buffer = new byte[256];
    private int start;
    private int count;
    private bool completed;
    private TaskCompletionSource? waiting;

    public void Write(ReadOnlySpan<byte> bytes)
    {
        TaskCompletionSource? reader;
        lock (gate)
        {
            if (completed)
            {
                return;
            }

            MakeRoom(bytes.Length);
            bytes.CopyTo(buffer.AsSpan(start + count));
            count += bytes.Length;
            reader = Taken();
        }

        reader?.TrySetResult();
    }

    /// <summary>No more bytes will come; what is there can still be read.</summary>
    public void Complete()
    {
        TaskCompletionSource? reader;
        lock (gate)
        {
            completed = true;
            reader = Taken();
        }

        reader?.TrySetResult();
    }

    /// <summary>At least one byte, or 0 after <see cref="Complete"/>.</summary>
    public async ValueTask<int> ReadAsync(Memory<byte> destination, CancellationToken cancellation)
    {
        while (true)
        {
            Task wait;
            lock (gate)
            {
                if (count > 0 || completed || destination.IsEmpty)
                {
                    return Take(destination.Span);
                }

                waiting ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
                wait = waiting.Task;
            }

            await wait.WaitAsync(cancellation).ConfigureAwait(false);
        }
    }

    private int Take(Span<byte> destination)
    {
        int taken = Math.Min(count, destination.Length);
        buffer.AsSpan(start, taken).CopyTo(destination);
        start += taken;
        count -= taken;
        start = count == 0 ? 0 : start;
        return taken;
    }

    private void MakeRoom(int length)
    {
        if (start + count + length <= buffer.Length)
        {
            return;
        }

        var larger = count + length <= buffer.Length ? buffer : new byte[Math.Max(buffer.Length * 2, count + length)];
        buffer.AsSpan(start, count).CopyTo(larger);
        buffer = larger;
        start = 0;
    }

    private TaskCompletionSource? Taken()
    {
        var reader = waiting;
        waiting = null;
        return reader;
    }
}
