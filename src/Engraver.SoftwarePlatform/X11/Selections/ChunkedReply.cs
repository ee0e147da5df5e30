namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Waits for a reply as long as pieces of it arrive: the timeout restarts with each piece, so that neither the size of the reply nor the load of
/// the computer ends the wait.</summary>
internal sealed class ChunkedReply : IDisposable
{
    private readonly TaskCompletionSource<byte[]?> _whole = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly ITimer _idleTimer;
    private readonly TimeSpan _idleTimeout;

    /// <param name="patience">The longest time without a piece.</param>
    public ChunkedReply(TimeSpan patience, TimeProvider time)
    {
        _idleTimeout = patience;
        _idleTimer = time.CreateTimer(_ => OnTimeout(), null, patience, Timeout.InfiniteTimeSpan);
    }

    /// <summary>The complete reply; null if there was none, or if it was not completed.</summary>
    public Task<byte[]?> Whole => _whole.Task;

    /// <summary>Called when the timeout has elapsed.</summary>
    public bool TimedOut { get; private set; }

    /// <summary>Called when a piece has arrived.</summary>
    public void OnPiece() => _idleTimer.Change(_idleTimeout, Timeout.InfiniteTimeSpan);

    public void Complete(byte[]? bytes) => _whole.TrySetResult(bytes);

    public void Dispose() => _idleTimer.Dispose();

    private void OnTimeout()
    {
        TimedOut = true;
        _whole.TrySetResult(null);
    }
}
