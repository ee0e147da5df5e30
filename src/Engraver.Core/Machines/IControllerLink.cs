namespace Engraver.Core.Machines;

/// <summary>Bytes to and from a controller over any medium: a socket, a serial line, memory. One reader and one writer at a time.</summary>
/// <remarks>Failures are <see cref="IOException"/>; the protocol above turns them into the three link exceptions.</remarks>
public interface IControllerLink : IAsyncDisposable
{
    /// <summary>The link as the operator names it, for example <c>tcp://10.0.0.5:23</c>.</summary>
    string Description { get; }

    /// <summary>The serial line under the link; null where the link is fast and can be opened twice.</summary>
    SerialLine? Line => null;

    /// <summary>When the controller took what was written last, by its own clock: ticks of 100 ns since it was switched on. Null where nobody knows.</summary>
    long? TakenTicks => null;

    /// <summary>The controller's own clock now, in the same ticks; null where nobody knows.</summary>
    long? NowTicks => null;

    ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <returns>The number of bytes read; 0 when the other side has closed.</returns>
    ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation);
}
