using System.Threading.Channels;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Tests.Sending;

/// <summary>A port in memory: stores sent bytes with their times, and sends given bytes at a given position.</summary>
internal sealed class MemoryPort(TimeProvider time) : IProgramPort
{
    private readonly Channel<byte> _said = Channel.CreateUnbounded<byte>();
    private readonly SemaphoreSlim _listens = new(0);
    private readonly long _begun = time.GetTimestamp();

    public List<(TimeSpan At, byte Bits)> Written { get; } = [];

    /// <summary>Sent after this number of received characters; the sender processes it before it continues.</summary>
    public (int At, byte Bits)? Answer { get; set; }

    /// <summary>The port fails after this number of characters.</summary>
    public int BreaksAt { get; set; } = int.MaxValue;

    public bool WasDrained { get; private set; }

    public int Count
    {
        get
        {
            lock (Written) return Written.Count;
        }
    }

    public void Receive(byte value) => _said.Writer.TryWrite(value);

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        if (Count + bytes.Length > BreaksAt) throw new IOException("the cable was pulled");
        lock (Written) Written.AddRange(bytes.ToArray().Select(one => (time.GetElapsedTime(_begun), one)));
        if (Answer is not { } answer || Count < answer.At) return;
        Answer = null;
        await _listens.WaitAsync(cancellation);
        Receive(answer.Bits);
        await _listens.WaitAsync(cancellation); // It was processed, and the sender listens again.
    }

    public async ValueTask<int> ReadAsync(Memory<byte> bytes, CancellationToken cancellation)
    {
        _listens.Release();
        var said = await _said.Reader.ReadAsync(cancellation);
        bytes.Span[0] = said;
        return 1;
    }

    public ValueTask DrainAsync(CancellationToken cancellation)
    {
        WasDrained = true;
        return ValueTask.CompletedTask;
    }

    public ValueTask DisposeAsync() => ValueTask.CompletedTask;
}
