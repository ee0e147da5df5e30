using Engraver.Core.Dxf;

namespace Engraver.TestKit;

/// <summary>A file that arrives no sooner than it is waited for. What has not arrived holds digits, so that who reads it reads another drawing.</summary>
/// <param name="more">Bytes that come beyond those waited for.</param>
public sealed class SlowBytes(byte[] file, Func<int> more) : IArrivingBytes
{
    private int _arrived;

    public byte[] Bytes { get; } = [.. Enumerable.Repeat((byte)'7', file.Length)];

    /// <summary>So many bytes can be read, then the disk fails.</summary>
    public int Readable { get; init; } = file.Length;

    /// <summary>Most bytes beyond those there that were waited for at a time.</summary>
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
