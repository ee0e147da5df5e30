using Avalonia.Threading;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>The loop of the user interface thread: signalled work, then the timer, then background work, then a wait without processor time for any of
/// them.</summary>
/// <remarks>Input is posted to the dispatcher like other work, so that nothing here depends on X. Time is the provider's: with a fake clock, timers are due
/// when the clock is advanced.</remarks>
internal sealed class SoftwareDispatcher : IControlledDispatcherImpl, IDispatcherImplWithExplicitBackgroundProcessing, IDisposable
{
    private readonly Thread _thread = Thread.CurrentThread;
    private readonly object _gate = new();
    private readonly TimeProvider _time;
    private readonly long _start;
    private readonly ITimer? _alarm; // only for a clock other than that of the wait below
    private bool _signalled;
    private bool _background;
    private long? _due;

    public SoftwareDispatcher(TimeProvider time)
    {
        _time = time;
        _start = time.GetTimestamp();
        if (time != TimeProvider.System) _alarm = time.CreateTimer(_ => Wake(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public event Action? Signaled;

    public event Action? Timer;

    public event Action? ReadyForBackgroundProcessing;

    public bool CurrentThreadIsLoopThread => Thread.CurrentThread == _thread;

    public long Now => (long)_time.GetElapsedTime(_start).TotalMilliseconds;

    /// <summary>Pending input is in the dispatcher's own queue, which knows its priority.</summary>
    public bool CanQueryPendingInput => false;

    public bool HasPendingInput => false;

    public void Signal()
    {
        lock (_gate)
        {
            _signalled = true;
            Monitor.PulseAll(_gate);
        }
    }

    public void RequestBackgroundProcessing()
    {
        lock (_gate)
        {
            _background = true;
            Monitor.PulseAll(_gate);
        }
    }

    public void UpdateTimer(long? dueTimeInMs)
    {
        lock (_gate)
        {
            _due = dueTimeInMs;
            Monitor.PulseAll(_gate);
        }

        _alarm?.Change(dueTimeInMs is { } due ? TimeSpan.FromMilliseconds(Math.Max(0, due - Now)) : Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public void RunLoop(CancellationToken token)
    {
        using var woken = token.Register(Wake);
        while (!token.IsCancellationRequested)
        {
            if (!RunOne()) WaitForWork(Timeout.InfiniteTimeSpan, token);
        }
    }

    /// <summary>Does one piece of work that is due; false when there is none.</summary>
    public bool RunOne()
    {
        var work = Take();
        work?.Invoke();
        return work is not null;
    }

    /// <summary>Handles each pending signal once. An unhandled one would keep <see cref="WaitForWork"/> from waiting.</summary>
    public void RunDue()
    {
        if (TakeTimer()) Timer?.Invoke();
        if (TakeCall(ref _signalled)) Signaled?.Invoke();
        if (TakeCall(ref _background)) ReadyForBackgroundProcessing?.Invoke();
    }

    /// <summary>Blocks until there is something to do, the token is cancelled or the timeout has elapsed.</summary>
    public void WaitForWork(TimeSpan atMost, CancellationToken token)
    {
        lock (_gate)
        {
            if (_signalled || _background || token.IsCancellationRequested || _due <= Now) return;
            Monitor.Wait(_gate, Shorter(atMost));
        }
    }

    public void Dispose() => _alarm?.Dispose();

    private void Wake()
    {
        lock (_gate) Monitor.PulseAll(_gate);
    }

    private Action? Take()
    {
        if (TakeCall(ref _signalled)) return () => Signaled?.Invoke();
        if (TakeTimer()) return () => Timer?.Invoke();
        return TakeCall(ref _background) ? () => ReadyForBackgroundProcessing?.Invoke() : null;
    }

    private bool TakeCall(ref bool called)
    {
        lock (_gate)
        {
            var was = called;
            called = false;
            return was;
        }
    }

    private bool TakeTimer()
    {
        lock (_gate)
        {
            if (!(_due <= Now)) return false;
            _due = null;
            return true;
        }
    }

    private TimeSpan Shorter(TimeSpan atMost)
    {
        if (_due is not { } due || _alarm is not null) return atMost;
        var untilDue = TimeSpan.FromMilliseconds(Math.Clamp(due - Now, 1, 60_000));
        return atMost == Timeout.InfiniteTimeSpan || untilDue < atMost ? untilDue : atMost;
    }
}
