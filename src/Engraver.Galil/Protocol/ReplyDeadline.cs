namespace Engraver.Galil.Protocol;

/// <summary>One timer for all replies of a channel. It stays armed and compares the time only when it fires, so that most commands do not touch a
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

    public ReplyDeadline(TimeProvider time)
    {
        _time = time;
        _timer = time.CreateTimer(_ => OnTimer(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    /// <summary>Cancelled when a reply was overdue, for good: the prompts that a channel missed can no longer be matched.</summary>
    public CancellationToken Expired => _expired.Token;

    public void Start(TimeSpan limit)
    {
        lock (_gate)
        {
            _started = _time.GetTimestamp();
            // A wait that is shorter than the armed one must not last as long as that.
            var mustArm = !_armed || limit < _limit;
            _limit = limit;
            _waiting = true;
            if (mustArm) Arm(limit);
        }
    }

    public void Stop()
    {
        lock (_gate) _waiting = false;
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
