using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>The clock that a controller in another process offers on loopback (contract, <c>?clock=PORT</c>). While this object exists, the controller's time
/// advances only through commands of this host and while this host waits.</summary>
/// <remarks> <para>The protocol consists of lines: <c>now</c> is answered with the controller's time, <c>wait N</c> with the time after N have passed, and
/// <c>stop</c> ends a wait. Times are whole microseconds.</para> <para>A timer that is created with a due time (<c>Task.Delay</c>) is a wait. A timer that is
/// created without one and set later is a deadline: it fires when the time is reached, and does not make time advance.</para> <para>When the other end is
/// closed or does not reply, the clock is released, and time continues with the wall clock from its last value, so that every wait and every deadline still
/// ends.</para> </remarks>
public sealed class SharedClock : TimeProvider, IDisposable
{
    /// <summary>Wall time after which a reply of the other end is overdue.</summary>
    private const int AnswerMilliseconds = 10_000;

    /// <summary>While a reply is awaited the time is not read; deadlines are then tested at this interval of wall time.</summary>
    private static readonly TimeSpan DeadlinePollInterval = TimeSpan.FromMilliseconds(250);

    private readonly Lock _gate = new();
    private readonly Socket _socket;
    private readonly byte[] _answer = new byte[64];
    private readonly List<Timer> _set = [];
    private readonly ITimer _looking;
    private long _known;
    private long _lostAt;
    private bool _isLost;
    private volatile bool _isKnown;
    private bool _isHostWaiting;
    private bool _isAsked;
    private long _askedFor;
    private long _started;

    private SharedClock(Socket socket)
    {
        _socket = socket;
        _looking = System.CreateTimer(_ => Poll(), null, DeadlinePollInterval, DeadlinePollInterval);
    }

    /// <summary>Ticks of 100 ns since the controller was switched on.</summary>
    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    /// <summary>Acquires the clock at this port of loopback.</summary>
    /// <exception cref="ControllerLinkException">No clock is offered at this port.</exception>
    public static SharedClock Acquire(int port)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true, ReceiveTimeout = AnswerMilliseconds, SendTimeout = AnswerMilliseconds };
        var clock = new SharedClock(socket);
        try
        {
            socket.Connect(IPAddress.Loopback, port);
            clock.Query("now\n");
            return clock;
        }
        catch (Exception failure) when (failure is SocketException or IOException)
        {
            clock.Dispose();
            throw new ControllerLinkException(
                Wording.Get("SharedClock.NoClock", port, SocketReason.Of(failure)), failure);
        }
    }

    public override long GetTimestamp()
    {
        List<Timer> due;
        long now;
        lock (_gate)
        {
            if (!_isKnown) QueryTime();
            now = Now;
            due = TakeDue();
        }

        Fire(due);
        return now;
    }

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        ArgumentNullException.ThrowIfNull(callback);
        var timer = new Timer(this, callback, state);
        if (dueTime != Timeout.InfiniteTimeSpan) Set(timer, dueTime, isWait: true);
        return timer;
    }

    /// <summary>Called when the controller has replied: its clock may have advanced. Without commands and waits it does not advance and need not be queried
    /// again.</summary>
    public void Invalidate() => _isKnown = false;

    /// <summary>Releases the clock and ends all waits.</summary>
    public void Dispose()
    {
        _looking.Dispose();
        _socket.Dispose();
        List<Timer> left;
        lock (_gate)
        {
            Release();
            left = [.. _set.Where(timer => timer.IsWait)];
            _set.Clear();
        }

        Fire(left);
    }

    private long Now => _isLost ? _known + System.GetElapsedTime(_lostAt).Ticks : _known;

    private void Set(Timer timer, TimeSpan due, bool isWait)
    {
        var now = due == Timeout.InfiniteTimeSpan || isWait ? 0 : GetTimestamp();
        lock (_gate)
        {
            // Ended early by a cancellation: the host is active, unless it has started another wait in the meantime.
            if (timer.IsWait && !isWait && _set.Contains(timer)) _isHostWaiting = _set.Exists(other => other.IsWait && other.Started > timer.Started);
            if (isWait) timer.Started = ++_started;
            timer.IsWait = isWait;
            _set.Remove(timer);
            if (due != Timeout.InfiniteTimeSpan) _set.Add(timer);
            if (isWait) _isHostWaiting = true;
            if (isWait && !_isKnown) QueryTime();
            timer.Due = due == Timeout.InfiniteTimeSpan ? long.MaxValue : (isWait ? Now : now) + due.Ticks;
            if (_isLost) return; // Look ends the wait
            if (_isAsked && (!_isHostWaiting || NextDue < _askedFor)) Try(() => Send("stop\n"));
            else if (!_isAsked && _isHostWaiting) AskToWait();
        }
    }

    private long NextDue => _set.Count == 0 ? long.MaxValue : _set.Min(timer => timer.Due);

    /// <summary>Under the lock: requests a wait up to the first timer.</summary>
    private void AskToWait()
    {
        _askedFor = NextDue;
        var microseconds = Math.Max(0, (_askedFor - _known + TimeSpan.TicksPerMicrosecond - 1) / TimeSpan.TicksPerMicrosecond);
        Try(() => Send(string.Create(CultureInfo.InvariantCulture, $"wait {microseconds}\n")));
        if (_isLost) return;
        _isAsked = true;
        ThreadPool.UnsafeQueueUserWorkItem(static clock => clock.TakeAnswer(), this, preferLocal: false);
    }

    private void TakeAnswer()
    {
        var answered = true;
        try
        {
            _known = Read(Timeout.Infinite);
        }
        catch (Exception failure) when (failure is SocketException or IOException or ObjectDisposedException)
        {
            answered = false;
        }

        List<Timer> due;
        lock (_gate)
        {
            _isAsked = false;
            _isKnown = true;
            if (!answered) Release();
            due = TakeDue();
            if (_isHostWaiting && !_isLost) AskToWait();
        }

        Fire(due);
    }

    /// <summary>Under the lock.</summary>
    private List<Timer> TakeDue()
    {
        var now = Now;
        if (!_set.Exists(timer => timer.Due <= now)) return [];
        var due = _set.Where(timer => timer.Due <= now).OrderBy(timer => timer.Due).ToList();
        _set.RemoveAll(due.Contains);
        if (due.Exists(timer => timer.IsWait)) _isHostWaiting = false;
        due.ForEach(timer => timer.IsWait = false);
        return due;
    }

    private static void Fire(List<Timer> due)
    {
        foreach (var timer in due) ThreadPool.UnsafeQueueUserWorkItem(static fired => fired.Fire(), timer, preferLocal: false);
    }

    /// <summary>Tests the deadlines while the host awaits a reply and does not read the clock; tests all timers when the other end is closed.</summary>
    private void Poll()
    {
        bool isDeadlineSet;
        lock (_gate)
        {
            isDeadlineSet = _set.Count > 0;
        }

        if (!isDeadlineSet) return;
        _isKnown = false;
        GetTimestamp();
    }

    /// <summary>Under the lock. During a wait the time comes with its reply.</summary>
    private void QueryTime()
    {
        if (_isAsked || _isLost) return;
        _isKnown = true; // any later reply makes it unknown again
        Try(() => Query("now\n"));
    }

    private void Query(string line)
    {
        Send(line);
        _known = Read(AnswerMilliseconds);
    }

    private void Send(string line) => _socket.Send(Encoding.ASCII.GetBytes(line));

    private long Read(int milliseconds)
    {
        _socket.ReceiveTimeout = milliseconds;
        for (var count = 0; ;)
        {
            var more = _socket.Receive(_answer.AsSpan(count));
            count += more;
            if (more == 0 || count == _answer.Length) throw new IOException(Wording.Get("SharedClock.Closed"));
            if (_answer[count - 1] != '\n') continue;
            return long.TryParse(_answer.AsSpan(0, count - 1), NumberStyles.None, CultureInfo.InvariantCulture, out var microseconds)
                ? microseconds * TimeSpan.TicksPerMicrosecond
                : throw new IOException(Wording.Get("SharedClock.NotClock"));
        }
    }

    private void Try(Action exchange)
    {
        try
        {
            exchange();
        }
        catch (Exception failure) when (failure is SocketException or IOException or ObjectDisposedException)
        {
            Release();
        }
    }

    /// <summary>Releases the clock: with a host that no longer waits, the controller would let no time pass and never come to rest.</summary>
    private void Release()
    {
        if (_isLost) return;
        (_isLost, _lostAt) = (true, System.GetTimestamp());
        _socket.Dispose();
    }

    private sealed class Timer(SharedClock clock, TimerCallback callback, object? state) : ITimer
    {
        public long Due { get; set; } = long.MaxValue;

        public bool IsWait { get; set; }

        /// <summary>Waits are ordered by their start.</summary>
        public long Started { get; set; }

        public void Fire() => callback(state);

        /// <remarks>The period is ignored because no caller uses it: a timer fires once.</remarks>
        public bool Change(TimeSpan dueTime, TimeSpan period)
        {
            clock.Set(this, dueTime, isWait: false);
            return true;
        }

        public void Dispose() => clock.Set(this, Timeout.InfiniteTimeSpan, isWait: false);

        public ValueTask DisposeAsync()
        {
            Dispose();
            return ValueTask.CompletedTask;
        }
    }
}
