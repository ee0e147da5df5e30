using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Machines.Alarms;

/// <summary>Raises and clears alarms according to controller readings and job results.</summary>
internal static class MachineAlarms
{
    public static void LinkLost(AlarmLog log, string link, string why) =>
        log.Raise(AlarmCause.LinkLost, why, link, Wording.Get("MachineAlarms.CheckCable"));

    public static void Refused(AlarmLog log, MachineRefusal refused, string link) =>
        log.Raise(AlarmCause.Refused, refused.Message, link, Wording.Get("MachineAlarms.CorrectAndRepeat"));

    /// <summary>Raises and clears alarms from a reading of the controller.</summary>
    /// <param name="axes">Names of the axes.</param>
    /// <param name="ended">A job that has ended since the last reading: a new cause in this reading has ended it, and both are one alarm. Null for
    /// none.</param>
    public static void Polled(AlarmLog log, MachineReading poll, MachineAxes axes, string link, JobResult? ended = null)
    {
        log.Clear(AlarmCause.LinkLost);
        if (ended is { Outcome: JobOutcome.Complete or JobOutcome.Deviated }) ended = ReportEnded(log, ended, link);
        if (Update(log, poll.AbortInput, AlarmCause.AbortInput, Wording.Get("MachineAlarms.AbortInputActive"), Wording.Get("MachineAlarms.ReleaseEmergencyStop"), link, ended)) ended = null;
        if (Update(log, poll.LostPosition.Length > 0, AlarmCause.FollowingError, Wording.Get("MachineAlarms.AxisOff", axes.NamesOf(poll.LostPosition)), Wording.Get("MachineAlarms.FreeAxis"), link, ended)) ended = null;
        if (Update(log, poll.Limit.Length > 0, AlarmCause.Limit, Wording.Get("MachineAlarms.LimitSwitchActive", poll.Limit), Wording.Get("MachineAlarms.MoveOffSwitch"), link, ended)) ended = null;
        if (ended is not null) JobEnded(log, ended, link);
    }

    private static JobResult? ReportEnded(AlarmLog log, JobResult ended, string link)
    {
        JobEnded(log, ended, link);
        return null;
    }

    /// <summary>Raises the alarm of a job that did not complete.</summary>
    public static void JobEnded(AlarmLog log, JobResult result, string link)
    {
        var cause = result switch
        {
            _ when result.Outcome.IsAsPlanned() => (AlarmCause?)null,
            { Outcome: JobOutcome.Stopped } => AlarmCause.JobStopped,
            { Outcome: JobOutcome.LinkLost } => result.Loss == LinkLoss.Watchdog ? AlarmCause.WatchdogTripped : AlarmCause.LinkLost,
            { Outcome: JobOutcome.Deviated } => AlarmCause.Deviated,
            { Refusal: not null } => AlarmCause.Refused,
            _ => AlarmCause.JobStopped,
        };
        if (cause is { } raised) log.Raise(raised, result.Message, Where(result, link), Wording.Get("MachineAlarms.CheckWorkpiece"));
    }

    /// <summary>Clears the alarms of an earlier job when a new one starts.</summary>
    public static void JobStarted(AlarmLog log)
    {
        foreach (var cause in new[] { AlarmCause.JobStopped, AlarmCause.Deviated, AlarmCause.Refused, AlarmCause.WatchdogTripped }) log.Clear(cause);
    }

    /// <returns>True if it was raised by this call.</returns>
    private static bool Update(AlarmLog log, bool stands, AlarmCause cause, string what, string toDo, string link, JobResult? ended)
    {
        if (!stands) log.Clear(cause);
        if (!stands || log.Open.Any(alarm => alarm.Cause == cause && alarm.IsActive)) return false;
        log.Raise(cause, ended is null ? what : Wording.Get("MachineAlarms.AlarmAndJobResult", what, ended.Message), ended is null ? link : Where(ended, link), toDo);
        return true;
    }

    private static string Where(JobResult ended, string link) => Wording.Get("MachineAlarms.LinkAndSegments", link, CountText.Format(ended.SegmentsExecuted, "Segment"));
}
