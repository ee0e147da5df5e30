namespace Engraver.Workbench.Playback;

/// <summary>How far AUTOSEQUENCE has walked along the contours of the drawing, for a canvas that lights up what was walked. Any thread.</summary>
public sealed class SequenceWalk
{
    private const int None = -1;
    private int _moves = None;

    /// <summary>Raised with each step, on the thread of the command.</summary>
    public event EventHandler? Changed;

    /// <summary>Moves of the toolpath that were walked; null while nobody walks.</summary>
    public int? Moves => Volatile.Read(ref _moves) is >= 0 and var walked ? walked : null;

    internal void Show(int moves) => Take(moves);

    internal void End()
    {
        if (Moves is not null) Take(None);
    }

    private void Take(int moves)
    {
        Volatile.Write(ref _moves, moves);
        Changed?.Invoke(this, EventArgs.Empty);
    }
}
