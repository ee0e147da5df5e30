namespace Engraver.Galil.Programs.Resident;

/// <summary>Decides when to send the heartbeat to the watchdog in the controller, which trips 1.0 s after the last one (galil-dmc.md EX12).</summary>
/// <remarks>May be called from two threads: a second heartbeat at the same time is harmless.</remarks>
/// <param name="time">The job's clock.</param>
internal sealed class Heartbeat(TimeProvider time)
{
    private static readonly TimeSpan s_between = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan s_withSegments = TimeSpan.FromMilliseconds(300);
    private static readonly TimeSpan s_latest = TimeSpan.FromMilliseconds(500);

    /// <summary>The job is delayed: a heartbeat is sent beside it, for this long at most after its last command, because a job that hangs must not keep the
    /// machine in motion.</summary>
    private static readonly TimeSpan s_beside = TimeSpan.FromMilliseconds(350);
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(5);

    private long _last = time.GetTimestamp();
    private long _acted = time.GetTimestamp();

    /// <summary>For a watchdog that trips 0.25 s after the last one (<see cref="ResidentProgram.CloseHeartbeatTicks"/>).</summary>
    public static Heartbeat Close(TimeProvider time) => new(time) { Between = TimeSpan.FromMilliseconds(50), Latest = TimeSpan.FromMilliseconds(100), IsKept = false, WatchdogSeconds = ResidentProgram.CloseHeartbeatTicks * StandstillLimit.TickSeconds };

    /// <summary>Time without a heartbeat after which the watchdog trips.</summary>
    public double WatchdogSeconds { get; private init; } = ResidentProgram.HeartbeatTicks * StandstillLimit.TickSeconds;

    private TimeSpan Between { get; init; } = s_between;

    private TimeSpan Latest { get; init; } = s_latest;

    /// <summary>False for motion that lasts as long as a key is held: it ends when the job is delayed.</summary>
    private bool IsKept { get; init; } = true;

    private TimeSpan Silence => time.GetElapsedTime(Volatile.Read(ref _last));

    /// <summary>True when a heartbeat is due; it then counts as sent.</summary>
    public bool IsDue() => IsActive() && IsSilentFor(Between);

    /// <summary>True when the job is late with its heartbeat, so that it must be sent beside it; it then counts as sent.</summary>
    public bool IsDueBeside() => IsKept && time.GetElapsedTime(Volatile.Read(ref _acted)) < s_patience && IsSilentFor(s_beside);

    /// <summary>True when a heartbeat is due in a line of segments, whose time it takes: less often; it then counts as sent. Such a line is short
    /// (<see cref="Language.StreamLines"/>).</summary>
    public bool IsDueWithSegments() => IsActive() && IsSilentFor(s_withSegments);

    /// <summary>True when the heartbeat would be too late after this exchange; the heartbeat then counts as sent.</summary>
    /// <param name="exchange">Time of a query and its reply on the serial line.</param>
    public bool IsDueBefore(TimeSpan exchange) => IsActive() && IsSilentFor(Latest - exchange);

    /// <summary>Notes that the job acts.</summary>
    private bool IsActive()
    {
        Volatile.Write(ref _acted, time.GetTimestamp());
        return true;
    }

    private bool IsSilentFor(TimeSpan limit)
    {
        if (Silence < limit || Silence == TimeSpan.Zero) return false;
        Volatile.Write(ref _last, time.GetTimestamp());
        return true;
    }
}
