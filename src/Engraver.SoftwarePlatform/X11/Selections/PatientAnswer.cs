namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Waits for a reply as long as pieces of it arrive: the timeout restarts with each piece, so that neither the size of the reply nor the load of
/// the computer ends the wait.</summary>
internal sealed class PatientAnswer : IDisposable
{
    private readonly TaskCompletionSource<byte[]?> _whole = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly ITimer _silence;
    private readonly TimeSpan _patience;

    /// <param name="patience">The longest time without a piece.</param>
    public PatientAnswer(TimeSpan patience, TimeProvider time)
    {
        _patience = patience;
        _silence = time.CreateTimer(_ => GiveUp(), null, patience, Timeout.InfiniteTimeSpan);
    }

    /// <summary>The complete reply; null if there was none, or if it was not completed.</summary>
    public Task<byte[]?> Whole => _whole.Task;

    /// <summary>Called when the timeout has elapsed.</summary>
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
