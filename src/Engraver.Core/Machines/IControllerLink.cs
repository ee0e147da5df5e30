namespace Engraver.Core.Machines;

/// <summary>Bytes to and from a controller over any medium: a socket, a serial line, memory. One reader and one writer at a time.</summary>
/// <remarks>Failures are <see cref="IOException"/>; the protocol above turns them into the three link exceptions.</remarks>
public interface IControllerLink : IAsyncDisposable
{
    /// <summary>The link as an address for the operator, for example <c>tcp://10.0.0.5:23</c>.</summary>
    string Description { get; }

    /// <summary>The serial line under the link; null for a fast link that can be opened twice.</summary>
    SerialLine? Line => null;

    /// <summary>Time at which the controller received the last written bytes, by its own clock: ticks of 100 ns since it was switched on. Null if
    /// unknown.</summary>
    long? ReceivedTicks => null;

    /// <summary>The present time of the controller's own clock, in the same ticks; null if unknown.</summary>
    long? NowTicks => null;

    ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <returns>The number of bytes read; 0 when the other side has closed.</returns>
    ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation);
}
