namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Waits for an answer as long as pieces of it arrive: only silence ends the wait, however large the answer is and however busy the
/// computer.</summary>
internal sealed class PatientAnswer : IDisposable
{
    private readonly TaskCompletionSource<byte[]?> _whole = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly ITimer _silence;
    private readonly TimeSpan _patience;

    /// <param name="patience">The longest silence.</param>
    public PatientAnswer(TimeSpan patience, TimeProvider time)
    {
        _patience = patience;
        _silence = time.CreateTimer(_ => GiveUp(), null, patience, Timeout.InfiniteTimeSpan);
    }

    /// <summary>The complete answer; null when there was none, or it was never completed.</summary>
    public Task<byte[]?> Whole => _whole.Task;

    /// <summary>Called when the silence has lasted too long.</summary>
    public bool GaveUp { get; private set; }

    /// <summary>Called when a piece has arrived.</summary>
    public void Hear() => _silence.Change(_patience, Timeout.InfiniteTimeSpan);

    public void Take(byte[]? bytes) => _whole.TrySetResult(bytes);

    public void Dispose() => _silence.Dispose();

    private void GiveUp()
    {
        GaveUp = true;
        _whole.TrySetResult(null);
    }
}
