namespace Engraver.Galil.Programs.Resident;

/// <summary>When the watchdog in the controller must hear from us again: it trips 1.0 s after the last time (galil-dmc.md EX12).</summary>
/// <param name="time">The job's clock.</param>
internal sealed class Heartbeat(TimeProvider time)
{
    private static readonly TimeSpan Between = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan Latest = TimeSpan.FromMilliseconds(500);

    private long _last = time.GetTimestamp();

    private TimeSpan Silent => time.GetElapsedTime(_last);

    /// <summary>True when a heartbeat is due, which is then taken as sent.</summary>
    public bool IsDue() => IsSilentFor(Between);

    /// <summary>True when the watchdog would have to wait too long if so much were said first; the heartbeat is then taken as sent.</summary>
    /// <param name="exchange">How long a question and its answer take on the serial line.</param>
    public bool IsDueBefore(TimeSpan exchange) => IsSilentFor(Latest - exchange);

    private bool IsSilentFor(TimeSpan limit)
    {
        if (Silent < limit || Silent == TimeSpan.Zero) return false;
        _last = time.GetTimestamp();
        return true;
    }
}
