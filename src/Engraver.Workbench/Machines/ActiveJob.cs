namespace Engraver.Workbench.Machines;

/// <summary>The job that a machine runs (one at a time), with its cancellation.</summary>
/// <param name="over">Called when a job has ended for any reason, before <see cref="RunAsync{T}"/> returns.</param>
/// <param name="changed">Called when a job has started and when it has ended.</param>
internal sealed class ActiveJob(Action over, Action changed)
{
    private readonly Lock _guard = new();
    private CancellationTokenSource? _stop;
    private Task _ended = Task.CompletedTask;

    /// <summary>Cancels the running job; null if none runs.</summary>
    public CancellationTokenSource? Stop
    {
        get
        {
            lock (_guard) return _stop;
        }
    }

    /// <summary>Runs a job, which <see cref="Stop"/> and the caller's token end.</summary>
    /// <exception cref="InvalidOperationException">A job is already running.</exception>
    public async Task<T> RunAsync<T>(Func<CancellationToken, Task<T>> run, CancellationToken cancellation)
    {
        var stop = new CancellationTokenSource(); // Not disposed: a stop may come at any time, and it has no timer.
        var ended = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        lock (_guard)
        {
            if (_stop is not null) throw new InvalidOperationException("A job runs already.");
            (_stop, _ended) = (stop, ended.Task);
        }

        try
        {
            await using var outer = cancellation.Register(stop.Cancel).ConfigureAwait(false);
            changed();
            return await run(stop.Token).ConfigureAwait(false);
        }
        finally
        {
            lock (_guard) _stop = null;
            over();
            ended.TrySetResult();
            changed();
        }
    }

    /// <summary>Cancels the running job and waits for its end.</summary>
    public async Task EndAsync()
    {
        Task ended;
        lock (_guard)
        {
            ended = _ended;
            _ = _stop?.CancelAsync();
        }

        await ended.ConfigureAwait(false);
    }
}
