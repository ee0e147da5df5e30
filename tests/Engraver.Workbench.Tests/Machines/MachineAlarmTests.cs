using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.TestKit;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Alarms for the end of a job: cause, text, location and remedy.</summary>
public class MachineAlarmTests
{
    private const string Link = "tcp://10.0.0.7:23";

    public static TheoryData<JobOutcome, LinkLoss?, AlarmCause> Ends => new()
    {
        { JobOutcome.LinkLost, LinkLoss.Link, AlarmCause.LinkLost },
        { JobOutcome.LinkLost, LinkLoss.Watchdog, AlarmCause.WatchdogTripped },
        { JobOutcome.LinkLost, null, AlarmCause.LinkLost },
        { JobOutcome.Stopped, null, AlarmCause.JobStopped },
        { JobOutcome.Refused, null, AlarmCause.JobStopped },
        { JobOutcome.Deviated, null, AlarmCause.Deviated },
    };

    [Theory]
    [MemberData(nameof(Ends))]
    public void Every_end_before_the_end_is_an_alarm_with_its_own_cause_and_the_jobs_own_words(JobOutcome outcome, LinkLoss? loss, AlarmCause cause)
    {
        var log = new AlarmLog(new ManualTimeProvider());
        MachineAlarms.JobEnded(log, Result(outcome) with { Loss = loss, Message = "The cable was cut.", SegmentsExecuted = 3 }, Link);

        var alarm = Assert.Single(log.All);
        Assert.Equal((cause, "The cable was cut.", $"{Link}, after 3 segments", AlarmState.Unacknowledged), (alarm.Cause, alarm.What, alarm.Where, alarm.State));
        Assert.Contains("Check the workpiece before the next start", alarm.ToDo, StringComparison.Ordinal);
    }

    [Fact]
    public void A_complete_job_raises_nothing_and_a_refusal_is_told_apart_from_a_stop()
    {
        var log = new AlarmLog(new ManualTimeProvider());
        MachineAlarms.JobEnded(log, Result(JobOutcome.Complete), Link);
        Assert.Empty(log.All);
        MachineAlarms.JobEnded(log, Result(JobOutcome.Refused) with { Refusal = new Rejected(TcCode.BeginNotValidWithMotorOff, "Begin not valid with motor off", "BGS").ToRefusal() }, Link);

        Assert.Equal(AlarmCause.Refused, Assert.Single(log.All).Cause);
    }

    [Fact]
    public void A_link_lost_while_idle_says_the_cable_and_where_and_is_cleared_when_the_controller_is_seen_again()
    {
        var log = new AlarmLog(new ManualTimeProvider());
        MachineAlarms.LinkLost(log, Link, "No answer for 2 s.");
        var alarm = log.All[0];
        Assert.Equal((AlarmCause.LinkLost, "No answer for 2 s.", Link), (alarm.Cause, alarm.What, alarm.Where));
        Assert.Contains("cable", alarm.ToDo, StringComparison.Ordinal);
        Assert.Contains("CNCCONNECT", alarm.ToDo, StringComparison.Ordinal);

        MachineAlarms.Polled(log, new MachineReading(default, default, IsMoving: false, MotorsOff: ""), MachineAxes.Default, Link);
        Assert.Equal(AlarmState.ClearedUnacknowledged, log.All[0].State);
    }

    [Fact]
    public void The_next_start_clears_a_tripped_watchdog_but_not_a_link_that_is_still_lost()
    {
        var log = new AlarmLog(new ManualTimeProvider());
        MachineAlarms.JobEnded(log, Result(JobOutcome.LinkLost) with { Loss = LinkLoss.Watchdog }, Link);
        MachineAlarms.JobEnded(log, Result(JobOutcome.LinkLost) with { Loss = LinkLoss.Link }, Link);
        MachineAlarms.JobStarted(log);

        Assert.Equal([AlarmState.ClearedUnacknowledged, AlarmState.Unacknowledged], log.All.Select(alarm => alarm.State));
    }

    /// <summary>A limit ended the job: one event, one alarm, which states both.</summary>
    [Theory]
    [InlineData("the forward limit of axis A", false, "", AlarmCause.Limit)]
    [InlineData("", true, "", AlarmCause.AbortInput)]
    [InlineData("", false, "B", AlarmCause.FollowingError)]
    public void What_ended_a_job_and_its_end_are_one_alarm(string limit, bool abort, string lost, AlarmCause cause)
    {
        var log = new AlarmLog(new ManualTimeProvider());
        var poll = new MachineReading(default, default, IsMoving: false, MotorsOff: "") { Limit = limit, AbortInput = abort, LostPosition = lost };

        MachineAlarms.Polled(log, poll, MachineAxes.Default, Link, Result(JobOutcome.Refused) with { Message = "The job stands in stroke 2.", SegmentsExecuted = 3 });

        var alarm = Assert.Single(log.All);
        Assert.Equal((cause, $"{Link}, after 3 segments"), (alarm.Cause, alarm.Where));
        Assert.EndsWith(" The job stands in stroke 2.", alarm.What, StringComparison.Ordinal);
    }

    [Fact]
    public void A_limit_that_stood_before_did_not_end_the_job()
    {
        var log = new AlarmLog(new ManualTimeProvider());
        var poll = new MachineReading(default, default, IsMoving: false, MotorsOff: "") { Limit = "the forward limit of axis A" };
        MachineAlarms.Polled(log, poll, MachineAxes.Default, Link);
        MachineAlarms.Polled(log, poll, MachineAxes.Default, Link, Result(JobOutcome.Stopped));
        Assert.Equal([AlarmCause.Limit, AlarmCause.JobStopped], log.All.Select(alarm => alarm.Cause));
    }

    /// <summary>The job reports a lost link, and then polling fails: the same event.</summary>
    [Theory]
    [InlineData(LinkLoss.Link, AlarmCause.LinkLost)]
    [InlineData(LinkLoss.Watchdog, AlarmCause.WatchdogTripped)]
    public void A_link_lost_in_a_job_is_one_alarm_and_a_later_loss_another(LinkLoss loss, AlarmCause cause)
    {
        using var model = new MachineStatusModel(new ManualTimeProvider(), () => { });
        model.Connected(Link, isSimulation: false, new MachineIdentity("DMC2143", 4));
        model.JobEnded(Result(JobOutcome.LinkLost) with { Loss = loss });
        model.LinkLost(new ControllerLinkException("Nobody answers."));
        Assert.Equal((cause, 1), (Assert.Single(model.Alarms.All).Cause, model.Alarms.All[0].Count));

        model.Polled(new MachineReading(default, default, IsMoving: false, MotorsOff: ""));
        model.Alarms.AcknowledgeAll();
        model.LinkLost(new ControllerLinkException("Nobody answers."));
        Assert.Equal(AlarmCause.LinkLost, Assert.Single(model.Alarms.All, alarm => alarm.IsActive && alarm.NeedsAcknowledging).Cause);
    }

    private static JobResult Result(JobOutcome outcome) => JobResult.NotStarted(0, "It ended.") with { Outcome = outcome };
}
