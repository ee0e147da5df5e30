using Engraver.Core.Dxf;

namespace Engraver.TestKit;

/// <summary>A file whose bytes arrive only when they are waited for. Bytes that have not arrived are digits, so that reading them too early gives another
/// drawing.</summary>
/// <param name="more">Number of bytes that arrive in addition to those waited for.</param>
public sealed class SlowFileBytes(byte[] file, Func<int> more) : IProgressiveBytes
{
    private int _arrived;

    public byte[] Bytes { get; } = [.. Enumerable.Repeat((byte)'7', file.Length)];

    /// <summary>Number of bytes that can be read before the disk fails.</summary>
    public int Readable { get; init; } = file.Length;

    /// <summary>Largest number of bytes, in addition to the arrived ones, that were waited for at a time.</summary>
    public int LongestWait { get; private set; }

    public int WaitFor(int count)
    {
        if (count > Readable) throw new IOException("the disk is broken");
        if (count <= _arrived) return _arrived;
        LongestWait = Math.Max(LongestWait, count - _arrived);
        var arrived = Math.Min(Readable, count + more());
        file.AsSpan(_arrived..arrived).CopyTo(Bytes.AsSpan(_arrived));
        return _arrived = arrived;
    }
}
