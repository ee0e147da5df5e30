namespace Engraver.Workbench.Playback;

/// <summary>Progress of the AUTOSEQUENCE animation, for a canvas that highlights the contours. Any thread.</summary>
public sealed class SequenceAnimation
{
    private const int None = -1;
    private int _moves = None;

    /// <summary>Raised with each step, on the thread of the command.</summary>
    public event EventHandler? Changed;

    /// <summary>Number of toolpath moves shown; null if the animation is not running.</summary>
    public int? Moves => Volatile.Read(ref _moves) is >= 0 and var walked ? walked : null;

    internal void SetMoves(int moves) => Set(moves);

    internal void End()
    {
        if (Moves is not null) Set(None);
    }

    private void Set(int moves)
    {
        Volatile.Write(ref _moves, moves);
        Changed?.Invoke(this, EventArgs.Empty);
    }
}
