namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Data that arrives in pieces (ICCCM 2.7.2): each piece is a property, and an empty one ends it.</summary>
internal sealed class IncrReceive
{
    private readonly List<byte> _bytes = [];

    /// <summary>The data received so far.</summary>
    public byte[] Bytes => [.. _bytes];

    /// <returns>True when this was the last piece.</returns>
    public bool Take(ReadOnlySpan<byte> piece)
    {
        _bytes.AddRange(piece);
        return piece.IsEmpty;
    }
}
