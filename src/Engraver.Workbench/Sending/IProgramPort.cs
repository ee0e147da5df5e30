namespace Engraver.Workbench.Sending;

/// <summary>A port over which programs are sent as plain characters: a serial port, or memory in a test. One reader and one writer at a time.</summary>
/// <remarks>Hardware flow control (RTS and CTS) is part of the port: a write waits until the receiver is ready.</remarks>
public interface IProgramPort : IAsyncDisposable
{
    /// <exception cref="IOException">The port failed, or accepted no data for too long.</exception>
    ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <returns>The number of bytes read; 0 if the other side has closed.</returns>
    /// <exception cref="IOException">The port failed.</exception>
    ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation);

    /// <summary>Waits until buffered data is sent; without it closing the port discards it.</summary>
    /// <exception cref="IOException">The port failed, or accepted no data for too long.</exception>
    ValueTask DrainAsync(CancellationToken cancellation);
}
