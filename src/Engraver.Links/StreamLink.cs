using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>A link over any stream, which it owns: the in-process simulator's bytes, or a test's.</summary>
public sealed class StreamLink(Stream stream, string description) : IControllerLink
{
    public string Description => description;

    /// <summary>The serial line that the stream represents; null for none.</summary>
    public SerialLine? Line { get; init; }

    /// <summary>As <see cref="IControllerLink.TakenTicks"/>; null where nobody knows.</summary>
    public Func<long>? Taken { get; init; }

    /// <summary>As <see cref="IControllerLink.NowTicks"/>; null where nobody knows.</summary>
    public Func<long>? Now { get; init; }

    public long? TakenTicks => Taken?.Invoke();

    public long? NowTicks => Now?.Invoke();

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await stream.WriteAsync(bytes, cancellation).ConfigureAwait(false);
        await stream.FlushAsync(cancellation).ConfigureAwait(false);
    }

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => stream.ReadAsync(buffer, cancellation);

    public ValueTask DisposeAsync() => stream.DisposeAsync();
}
