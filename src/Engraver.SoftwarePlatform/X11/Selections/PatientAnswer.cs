namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>An answer that is waited for as long as something of it comes: only silence ends the waiting, however large the whole is and however busy the computer.</summary>
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

    /// <summary>The whole answer; null when there is none, or it never came to its end.</summary>
    public Task<byte[]?> Whole => _whole.Task;

    /// <summary>Nobody has spoken for too long.</summary>
    public bool GaveUp { get; private set; }

    /// <summary>A piece has come.</summary>
    public void Hear() => _silence.Change(_patience, Timeout.InfiniteTimeSpan);

    public void Take(byte[]? bytes) => _whole.TrySetResult(bytes);

    public void Dispose() => _silence.Dispose();

    private void GiveUp()
    {
        GaveUp = true;
        _whole.TrySetResult(null);
    }
}
