namespace Engraver.Workbench.Sending;

/// <summary>A line over which a program goes out as plain characters; a serial port, or memory in a test. One reader and one writer at a time.</summary>
/// <remarks>Hardware flow control (RTS and CTS) is the line's own: a write then waits until the other side is ready.</remarks>
public interface IProgramLine : IAsyncDisposable
{
    /// <exception cref="IOException">The line is gone, or took nothing for too long.</exception>
    ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <returns>The number of bytes read; 0 when the other side has closed.</returns>
    /// <exception cref="IOException">The line is gone.</exception>
    ValueTask<int> ReadAsync(Memory<byte> bytes, CancellationToken cancellation);

    /// <summary>Lets what was written go out before the line is closed; without it the line drops what it still holds.</summary>
    /// <exception cref="IOException">The line is gone, or took nothing for too long.</exception>
    ValueTask DrainAsync(CancellationToken cancellation);
}
