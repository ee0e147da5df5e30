using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>A link over any stream, which it owns: the bytes of the in-process simulator, or of a test.</summary>
public sealed class StreamLink(Stream stream, string description) : IControllerLink
{
    public string Description => description;

    /// <summary>The serial line that the stream represents; null for none.</summary>
    public SerialLine? Line { get; init; }

    /// <summary>See <see cref="IControllerLink.ReceivedTicks"/>; null if unknown.</summary>
    public Func<long>? Received { get; init; }

    /// <summary>See <see cref="IControllerLink.NowTicks"/>; null if unknown.</summary>
    public Func<long>? Now { get; init; }

    public long? ReceivedTicks => Received?.Invoke();

    public long? NowTicks => Now?.Invoke();

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await stream.WriteAsync(bytes, cancellation).ConfigureAwait(false);
        await stream.FlushAsync(cancellation).ConfigureAwait(false);
    }

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => stream.ReadAsync(buffer, cancellation);

    public ValueTask DisposeAsync() => stream.DisposeAsync();
}
