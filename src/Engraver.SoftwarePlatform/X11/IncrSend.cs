namespace Engraver.SoftwarePlatform.X11;

/// <summary>Data that goes out in pieces (ICCCM 2.7.2): each time the reader deletes the property the next piece follows, and one of no length ends it.</summary>
internal sealed class IncrSend(ReadOnlyMemory<byte> bytes, int pieceLength)
{
    private int _sent;

    /// <summary>True when the piece of no length has been given out.</summary>
    public bool IsDone { get; private set; }

    public ReadOnlyMemory<byte> NextPiece()
    {
        var piece = bytes.Slice(_sent, Math.Min(pieceLength, bytes.Length - _sent));
        _sent += piece.Length;
        IsDone = piece.IsEmpty;
        return piece;
    }
}
