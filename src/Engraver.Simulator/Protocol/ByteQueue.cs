namespace Engraver.Simulator.Protocol;

/// <summary>Bytes queued for one reader. Writing never waits; reading completes at once while bytes are available.</summary>
internal sealed class ByteQueue
{
    private readonly Lock _gate = new();
    private byte[] _buffer = new byte[256];
    private int _start;
    private int _count;
    private bool _completed;
    private TaskCompletionSource? _waiting;
    private int _readers;

    /// <summary>A reader waits for bytes and the queue is empty.</summary>
    public bool IsRead
    {
        get
        {
            lock (_gate)
            {
                return _readers > 0 && _count == 0;
            }
        }
    }

    /// <summary>Bytes that have not been read.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
            {
                return _count;
            }
        }
    }

    public void Write(ReadOnlySpan<byte> bytes)
    {
        TaskCompletionSource? reader;
        lock (_gate)
        {
            if (_completed) return;

            MakeRoom(bytes.Length);
            bytes.CopyTo(_buffer.AsSpan(_start + _count));
            _count += bytes.Length;
            reader = Taken();
        }

        reader?.TrySetResult();
    }

    /// <summary>Marks the end of the bytes; those already in the queue can still be read.</summary>
    public void Complete()
    {
        TaskCompletionSource? reader;
        lock (_gate)
        {
            _completed = true;
            reader = Taken();
        }

        reader?.TrySetResult();
    }

    /// <summary>Reads at least one byte; returns 0 after <see cref="Complete"/> when the queue is empty.</summary>
    public async ValueTask<int> ReadAsync(Memory<byte> destination, CancellationToken cancellation)
    {
        while (true)
        {
            Task wait;
            lock (_gate)
            {
                if (_count > 0 || _completed || destination.IsEmpty) return Take(destination.Span);

                _waiting ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
                wait = _waiting.Task;
                _readers++;
            }

            try
            {
                await wait.WaitAsync(cancellation).ConfigureAwait(false);
            }
            finally
            {
                lock (_gate) _readers--;
            }
        }
    }

    private int Take(Span<byte> destination)
    {
        var taken = Math.Min(_count, destination.Length);
        _buffer.AsSpan(_start, taken).CopyTo(destination);
        _start += taken;
        _count -= taken;
        _start = _count == 0 ? 0 : _start;
        return taken;
    }

    private void MakeRoom(int length)
    {
        if (_start + _count + length <= _buffer.Length) return;

        var larger = _count + length <= _buffer.Length ? _buffer : new byte[Math.Max(_buffer.Length * 2, _count + length)];
        _buffer.AsSpan(_start, _count).CopyTo(larger);
        _buffer = larger;
        _start = 0;
    }

    private TaskCompletionSource? Taken()
    {
        var reader = _waiting;
        _waiting = null;
        return reader;
    }
}
