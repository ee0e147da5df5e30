using System.IO.Pipelines;

namespace Engraver.Links.Serial;

/// <summary>Bytes that a thread has received and a link has not read yet. A read that is cancelled loses no byte.</summary>
internal sealed class ReceivedBytes
{
    private readonly Pipe _pipe = new(new PipeOptions(pauseWriterThreshold: 0, resumeWriterThreshold: 0, useSynchronizationContext: false));
    private readonly Stream _incoming;
    private readonly Lock _gate = new();
    private bool _hasEnded;

    public ReceivedBytes() => _incoming = _pipe.Reader.AsStream();

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => _incoming.ReadAsync(buffer, cancellation);

    /// <summary>Appends bytes; they are dropped after the end.</summary>
    public void Add(ReadOnlySpan<byte> bytes)
    {
        lock (_gate)
        {
            if (_hasEnded) return;
            bytes.CopyTo(_pipe.Writer.GetSpan(bytes.Length));
            _pipe.Writer.Advance(bytes.Length);

            // Without a threshold the flush completes at once; the reader runs on a separate thread.
            _pipe.Writer.FlushAsync(CancellationToken.None).AsTask().GetAwaiter().GetResult();
        }
    }

    /// <summary>Fails the reads that follow the bytes received so far.</summary>
    public void End(IOException failure)
    {
        lock (_gate)
        {
            if (_hasEnded) return;
            _hasEnded = true;
            _pipe.Writer.Complete(failure);
        }
    }
}
