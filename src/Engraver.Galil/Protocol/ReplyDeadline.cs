namespace Engraver.Galil.Protocol;

/// <summary>One timer for all replies of a channel. It remains armed and compares the time only when it fires, so that most commands do not change a
/// timer.</summary>
internal sealed class ReplyDeadline : IDisposable
{
    private readonly TimeProvider _time;
    private readonly ITimer _timer;
    private readonly CancellationTokenSource _expired = new();
    private readonly Lock _gate = new();
    private long _started;
    private TimeSpan _limit;
    private bool _waiting;
    private bool _armed;
    private long _busySince;
    private TimeSpan _busy;

    public ReplyDeadline(TimeProvider time)
    {
        _time = time;
        _timer = time.CreateTimer(_ => OnTimer(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    /// <summary>Cancelled permanently when a reply was overdue: the missed prompts can no longer be matched.</summary>
    public CancellationToken Expired => _expired.Token;

    /// <summary>Total time of all waits, from their first <see cref="Start"/> to <see cref="Stop"/>.</summary>
    public TimeSpan Busy
    {
        get
        {
            lock (_gate) return _waiting ? _busy + _time.GetElapsedTime(_busySince) : _busy;
        }
    }

    public void Start(TimeSpan limit)
    {
        lock (_gate)
        {
            _started = _time.GetTimestamp();
            if (!_waiting) _busySince = _started;
            // A wait that ends before the armed time must not last that long.
            var mustArm = !_armed || limit < _limit;
            _limit = limit;
            _waiting = true;
            if (mustArm) Arm(limit);
        }
    }

    public void Stop()
    {
        lock (_gate)
        {
            if (_waiting) _busy += _time.GetElapsedTime(_busySince);
            _waiting = false;
        }
    }

    public void Dispose()
    {
        _timer.Dispose();
        _expired.Dispose();
    }

    private void Arm(TimeSpan due)
    {
        _armed = true;
        _timer.Change(due, Timeout.InfiniteTimeSpan);
    }

    private void OnTimer()
    {
        lock (_gate)
        {
            _armed = false;
            if (!_waiting) return;
            var rest = _limit - _time.GetElapsedTime(_started);
            if (rest > TimeSpan.Zero)
            {
                Arm(rest);
                return;
            }
        }

        // Outside the lock, because callbacks of the token may run here.
        _expired.Cancel();
    }
}
