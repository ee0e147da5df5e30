using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Machines.Alarms;

/// <summary>What becomes an alarm, and what clears it.</summary>
internal static class MachineAlarms
{
    public static void LinkLost(AlarmLog log, string link, string why) =>
        log.Raise(AlarmCause.LinkLost, why, link, "Look at the cable and the controller's power, then CNCCONNECT again. Where the machine stands must be checked before a job goes on.");

    public static void Refused(AlarmLog log, MachineRefusal refused, string link) =>
        log.Raise(AlarmCause.Refused, refused.Sentence, link, "The controller said why; mend that and repeat the command.");

    /// <summary>By what stands in the controller now.</summary>
    public static void Seen(AlarmLog log, MachineReading poll, string link)
    {
        log.Clear(AlarmCause.LinkLost);
        Standing(log, poll.Limit.Length > 0, AlarmCause.Limit, $"The machine stands on {poll.Limit}.", "Move the axis off the switch; a job that was stopped by it must be looked at.", link);
        Standing(log, poll.LostPosition.Length > 0, AlarmCause.FollowingError, $"Axis {poll.LostPosition} was switched off because it stood too far from its command.", "Find out what held the axis, then CNCMOTORS ON.", link);
        Standing(log, poll.AbortInput, AlarmCause.AbortInput, "The abort input is active.", "Release the emergency stop; nothing starts by that alone.", link);
    }

    /// <summary>By how a job ended; a complete one raises nothing.</summary>
    public static void Ended(AlarmLog log, JobResult result, string link)
    {
        var cause = result switch
        {
            { Outcome: JobOutcome.Complete } => (AlarmCause?)null,
            { Outcome: JobOutcome.Stopped } => AlarmCause.JobStopped,
            { Outcome: JobOutcome.LinkLost } => result.Loss == LinkLoss.Watchdog ? AlarmCause.WatchdogTripped : AlarmCause.LinkLost,
            { Outcome: JobOutcome.Deviated } => AlarmCause.Deviated,
            { Refusal: not null } => AlarmCause.Refused,
            _ => AlarmCause.JobStopped,
        };
        if (cause is { } raised) log.Raise(raised, result.Sentence, $"{link}, after {CountText.Format(result.SegmentsExecuted, "segment")}", "The journal says what is engraved; look at the work piece before another start.");
    }

    /// <summary>What a new start leaves behind.</summary>
    public static void Begun(AlarmLog log)
    {
        foreach (var cause in new[] { AlarmCause.JobStopped, AlarmCause.Deviated, AlarmCause.Refused, AlarmCause.WatchdogTripped }) log.Clear(cause);
    }

    private static void Standing(AlarmLog log, bool stands, AlarmCause cause, string what, string toDo, string link)
    {
        if (!stands) log.Clear(cause);
        else if (!log.Open.Any(alarm => alarm.Cause == cause && alarm.IsActive)) log.Raise(cause, what, link, toDo);
    }
}
