namespace Engraver.Workbench.Machines;

/// <summary>The one job that a machine runs at a time, and what ends it before its end.</summary>
/// <param name="over">Called when a job has ended, in whatever way, before the caller of <see cref="RunAsync{T}"/> is told.</param>
/// <param name="changed">Called when one has begun and when it is over.</param>
internal sealed class ActiveJob(Action over, Action changed)
{
    private readonly Lock _guard = new();
    private CancellationTokenSource? _stop;
    private Task _ended = Task.CompletedTask;

    /// <summary>Ends the job under way; null when none is.</summary>
    public CancellationTokenSource? Stop
    {
        get
        {
            lock (_guard) return _stop;
        }
    }

    /// <summary>Runs a job, which <see cref="Stop"/> and the caller's token end.</summary>
    /// <exception cref="InvalidOperationException">A job runs already.</exception>
    public async Task<T> RunAsync<T>(Func<CancellationToken, Task<T>> run, CancellationToken cancellation)
    {
        var stop = new CancellationTokenSource(); // not disposed: a stop may come at any moment, and it holds no timer
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

    /// <summary>Ends the job under way and waits for its end.</summary>
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
