namespace Engraver.Galil.Programs.Resident;

/// <summary>Decides when to send the heartbeat to the watchdog in the controller, which trips 1.0 s after the last one (galil-dmc.md EX12).</summary>
/// <param name="time">The job's clock.</param>
internal sealed class Heartbeat(TimeProvider time)
{
    private static readonly TimeSpan s_between = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan s_withSegments = TimeSpan.FromMilliseconds(300);
    private static readonly TimeSpan s_latest = TimeSpan.FromMilliseconds(500);

    private long _last = time.GetTimestamp();

    /// <summary>For a watchdog that trips 0.25 s after the last one (<see cref="ResidentProgram.CloseHeartbeatTicks"/>).</summary>
    public static Heartbeat Close(TimeProvider time) => new(time) { Between = TimeSpan.FromMilliseconds(50), Latest = TimeSpan.FromMilliseconds(100), WatchdogSeconds = ResidentProgram.CloseHeartbeatTicks * StandstillLimit.TickSeconds };

    /// <summary>Time without a heartbeat after which the watchdog trips.</summary>
    public double WatchdogSeconds { get; private init; } = ResidentProgram.HeartbeatTicks * StandstillLimit.TickSeconds;

    private TimeSpan Between { get; init; } = s_between;

    private TimeSpan Latest { get; init; } = s_latest;

    private TimeSpan Silence => time.GetElapsedTime(_last);

    /// <summary>True when a heartbeat is due; it then counts as sent.</summary>
    public bool IsDue() => IsSilentFor(Between);

    /// <summary>True when a heartbeat is due in a line of segments, whose time it takes: less often; it then counts as sent. Such a line is short
    /// (<see cref="Language.StreamLines"/>).</summary>
    public bool IsDueWithSegments() => IsSilentFor(s_withSegments);

    /// <summary>True when the heartbeat would be too late after this exchange; the heartbeat then counts as sent.</summary>
    /// <param name="exchange">Time of a query and its reply on the serial line.</param>
    public bool IsDueBefore(TimeSpan exchange) => IsSilentFor(Latest - exchange);

    private bool IsSilentFor(TimeSpan limit)
    {
        if (Silence < limit || Silence == TimeSpan.Zero) return false;
        _last = time.GetTimestamp();
        return true;
    }
}
