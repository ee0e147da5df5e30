using Avalonia.Threading;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>The user interface thread's loop: work that was signalled, then the timer, then background work, then a wait that costs nothing until one of them comes.</summary>
/// <remarks>Input is posted to the dispatcher like any other work, so nothing here knows of X. Time is the provider's: under a fake clock, timers fall due when the clock is moved.</remarks>
internal sealed class SoftwareDispatcher : IControlledDispatcherImpl, IDispatcherImplWithExplicitBackgroundProcessing, IDisposable
{
    private readonly Thread _thread = Thread.CurrentThread;
    private readonly object _gate = new();
    private readonly TimeProvider _time;
    private readonly long _start;
    private readonly ITimer? _alarm; // only for a clock that the wait below cannot know
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

    /// <summary>Input stands in the dispatcher's own queue, which knows its priority.</summary>
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

    /// <summary>Does one piece of what is due now; false when there was nothing.</summary>
    public bool RunOne()
    {
        var work = Take();
        work?.Invoke();
        return work is not null;
    }

    /// <summary>Answers everything that calls now, once. What is left unanswered would keep <see cref="WaitForWork"/> from waiting.</summary>
    public void RunDue()
    {
        if (TakeTimer()) Timer?.Invoke();
        if (TakeCall(ref _signalled)) Signaled?.Invoke();
        if (TakeCall(ref _background)) ReadyForBackgroundProcessing?.Invoke();
    }

    /// <summary>Blocks until there is something to do, the token is cancelled or the time is over.</summary>
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
