using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Machines.Alarms;

/// <summary>What becomes an alarm, and what clears it.</summary>
internal static class MachineAlarms
{
    public static void LinkLost(AlarmLog log, string link, string why) =>
        log.Raise(AlarmCause.LinkLost, why, link, Wording.Get("MachineAlarms.LookCableControllerPower"));

    public static void Refused(AlarmLog log, MachineRefusal refused, string link) =>
        log.Raise(AlarmCause.Refused, refused.Sentence, link, Wording.Get("MachineAlarms.ControllerSaidWhyMend"));

    /// <summary>By what stands in the controller now.</summary>
    public static void Seen(AlarmLog log, MachineReading poll, string link)
    {
        log.Clear(AlarmCause.LinkLost);
        Standing(log, poll.Limit.Length > 0, AlarmCause.Limit, Wording.Get("MachineAlarms.MachineStandsOn", poll.Limit), Wording.Get("MachineAlarms.MoveAxisOffSwitch"), link);
        Standing(log, poll.LostPosition.Length > 0, AlarmCause.FollowingError, Wording.Get("MachineAlarms.AxisSwitchedOffBecause", poll.LostPosition), Wording.Get("MachineAlarms.FindOutWhatHeld"), link);
        Standing(log, poll.AbortInput, AlarmCause.AbortInput, Wording.Get("MachineAlarms.AbortInputActive"), Wording.Get("MachineAlarms.ReleaseEmergencyStopNothing"), link);
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
        if (cause is { } raised) log.Raise(raised, result.Sentence, Wording.Get("MachineAlarms.After", link, CountText.Format(result.SegmentsExecuted, "Segment")), Wording.Get("MachineAlarms.JournalSaysWhatEngraved"));
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
