namespace Engraver.SoftwarePlatform.X11;

/// <summary>Data that comes in pieces (ICCCM 2.7.2): each piece is a property, and one of no length ends it.</summary>
internal sealed class IncrReceive
{
    private readonly List<byte> _bytes = [];

    /// <summary>Everything so far.</summary>
    public byte[] Bytes => [.. _bytes];

    /// <returns>True when this was the end.</returns>
    public bool Take(ReadOnlySpan<byte> piece)
    {
        _bytes.AddRange(piece);
        return piece.IsEmpty;
    }
}
