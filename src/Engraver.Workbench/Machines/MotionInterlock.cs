namespace Engraver.Workbench.Machines;

/// <summary>Lets one thing at a time move the machine: a job, a move by hand, or the jogs of a controller that is kept ready for them. The only owner of
/// what moves the machine. Any thread.</summary>
/// <remarks>
/// <para>One motion at a time: <see cref="RunAsync{T}"/> refuses a second one before anything is sent.</para>
/// <para>A motion can always be stopped: <see cref="Stop"/> is there from before its first command until it has ended, and is never disposed of.</para>
/// <para>A controller that is only kept ready counts as free: whatever else needs it calls <see cref="FreeAsync"/> first, which waits until the controller
/// has been left as it was found.</para>
/// <para>A connection ends after its motion: <see cref="EndAsync"/> stops the motion and waits for its end before the connection is closed.</para>
/// </remarks>
/// <param name="over">Called when a motion has ended, in whatever way, before the caller of <see cref="RunAsync{T}"/> continues.</param>
/// <param name="changed">Called when a motion has started and when it has ended.</param>
internal sealed class MotionInterlock(Action over, Action changed)
{
    private readonly Lock _guard = new();
    private CancellationTokenSource? _stop;
    private Task _ended = Task.CompletedTask;
    private StandbyMachine? _ready;

    /// <summary>Ends the motion under way; null when none is.</summary>
    public CancellationTokenSource? Stop
    {
        get
        {
            lock (_guard) return _stop;
        }
    }

    /// <summary>A job or a move is under way.</summary>
    public bool IsRunning => Stop is not null && !IsKeptReady;

    /// <summary>The controller is kept ready for a jog, and no jog is under way.</summary>
    public bool IsKeptReady => Ready is { Standby.Pressed: null };

    /// <summary>Jogs for which the controller is kept ready, also while one of them is under way; null when there are none.</summary>
    public StandbyMachine? Ready => Volatile.Read(ref _ready);

    /// <summary>The motion that begins next keeps the controller ready for jogs.</summary>
    public void KeepReady(StandbyMachine ready) => Volatile.Write(ref _ready, ready);

    /// <summary>The controller has been left as it was found.</summary>
    public void EndReady(StandbyMachine ready)
    {
        Interlocked.CompareExchange(ref _ready, null, ready);
        ready.Close();
    }

    /// <summary>Ends the standby of a controller that is only kept ready, and waits for its end; does nothing otherwise.</summary>
    public Task FreeAsync()
    {
        if (Ready is not { Standby.Pressed: null } ready) return Task.CompletedTask;
        ready.Standby.Leave();
        return ready.Closed;
    }

    /// <summary>Runs a motion, which <see cref="Stop"/> and the caller's token end.</summary>
    /// <exception cref="InvalidOperationException">Another motion is under way.</exception>
    public async Task<T> RunAsync<T>(Func<CancellationToken, Task<T>> run, CancellationToken cancellation)
    {
        var stop = new CancellationTokenSource(); // not disposed of: a stop may come at any moment, and it holds no timer
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

    /// <summary>Stops the motion under way and waits for its end.</summary>
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
