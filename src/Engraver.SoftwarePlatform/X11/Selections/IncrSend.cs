namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Data that is sent in pieces (ICCCM 2.7.2): each time the reader deletes the property the next piece follows, and an empty one ends it.</summary>
internal sealed class IncrSend(ReadOnlyMemory<byte> bytes, int pieceLength)
{
    private int _sent;

    /// <summary>True when the empty last piece was sent.</summary>
    public bool IsDone { get; private set; }

    public ReadOnlyMemory<byte> NextPiece()
    {
        var piece = bytes.Slice(_sent, Math.Min(pieceLength, bytes.Length - _sent));
        _sent += piece.Length;
        IsDone = piece.IsEmpty;
        return piece;
    }
}
