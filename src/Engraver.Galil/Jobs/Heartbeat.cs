using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>When the watchdog in the controller must hear from us again: it trips 1.0 s after the last time (galil-dmc.md EX12).</summary>
/// <remarks>Counted on the wall, in commands, in bytes and in the controller's own samples: with a simulator at full speed the controller's time is the number of commands, 1.6 ms each, or the bytes on the serial line.</remarks>
internal sealed class Heartbeat(ControllerSession session)
{
    private const int CommandsBetween = 64;
    private const int CommandsBetweenWhereTimeRunsAhead = 8;
    private const int SamplesBetween = 200;
    private static readonly TimeSpan Between = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan Latest = TimeSpan.FromMilliseconds(500);

    /// <summary>How far a heartbeat winds the watchdog up.</summary>
    public WatchdogLimit Limit { get; set; } = WatchdogLimit.OneSecond;

    private long _last = session.Time.GetTimestamp();
    private TimeSpan _lastOnWire = session.WireTime;
    private int _commands;
    private long? _lastSample;
    private long _sample;

    /// <summary>The controller's own time, as polled last: where it runs faster than the wall, it decides.</summary>
    public void Saw(long sample)
    {
        _sample = sample;
        _lastSample ??= sample;
    }

    /// <summary>Counts one command; true when a heartbeat is due, which is then taken as sent.</summary>
    public bool IsDueAfterCommand()
    {
        var most = session.ClockRunsAhead && session.Line is null ? CommandsBetweenWhereTimeRunsAhead : CommandsBetween; // on a serial line the bytes tell
        var isEarly = _lastSample is not { } beat || _sample - beat < Limit.Samples(SamplesBetween);
        if (++_commands < most && isEarly && session.Time.GetElapsedTime(_last) < Between && session.WireTime - _lastOnWire < Between) return false;
        Reset();
        return true;
    }

    /// <summary>True when the watchdog would have to wait too long if so much were said first; the heartbeat is then taken as sent.</summary>
    /// <param name="exchange">How long a question and its answer take on the serial line.</param>
    public bool IsDueBefore(TimeSpan exchange)
    {
        var silent = session.WireTime - _lastOnWire;
        if (silent == TimeSpan.Zero || silent + exchange < Latest) return false;
        Reset();
        return true;
    }

    public void Reset()
    {
        _commands = 0;
        if (_lastSample is not null) _lastSample = _sample;
        _last = session.Time.GetTimestamp();
        _lastOnWire = session.WireTime;
    }
}
