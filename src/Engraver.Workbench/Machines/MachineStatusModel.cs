using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Machines;

/// <summary>Status of the machine, collected from polls and jobs, with the resulting alarms and arming. Any thread; it sends nothing.</summary>
internal sealed class MachineStatusModel : IDisposable
{
    private readonly Lock _guard = new();
    private readonly TimeProvider _time;
    private readonly Action _changed;
    private MachineFacts _facts = MachineFacts.None;
    private MachineProfile _profile = MachineProfile.Default;

    /// <summary>An ended job whose alarm is deferred to the next poll, which shows whether a limit or an input ended it; then only that alarm is
    /// raised.</summary>
    private JobResult? _ended;

    /// <summary>True after the alarm of a lost link was raised by the job or by a poll.</summary>
    private volatile bool _isLossReported;

    public MachineStatusModel(TimeProvider time, Action changed)
    {
        (_time, _changed) = (time, changed);
        Arming = new ArmingSwitch(time, changed);
        Alarms = new AlarmLog(time);
    }

    public ArmingSwitch Arming { get; }

    public AlarmLog Alarms { get; }

    public MachineStatus Status
    {
        get
        {
            lock (_guard) return _facts.ToStatus(_profile, Arming.Armed);
        }
    }

    /// <summary>The machine profile; setting another one disarms.</summary>
    public MachineProfile Profile
    {
        get
        {
            lock (_guard) return _profile;
        }

        set
        {
            ArgumentNullException.ThrowIfNull(value);
            lock (_guard)
            {
                if (_profile == value) return;
                _profile = value;
            }

            DisarmOrNotify();
        }
    }

    private string Link
    {
        get
        {
            lock (_guard) return _facts.Link ?? "";
        }
    }

    /// <summary>Notes a new connection. The outcome of the last job is kept if the address is the same, but not that of a simulated controller, which is new
    /// each time.</summary>
    public void Connected(string link, bool isSimulation, MachineIdentity identity) => Change(before => new MachineFacts
    {
        FeedRatio = before.FeedRatio,
        RapidRatio = before.RapidRatio,
        Link = link,
        IsSimulation = isSimulation,
        Identity = identity,
        LastAnswerTime = _time.GetUtcNow(),
        LastLink = link,
        LastOutcome = !isSimulation && before.LastLink == link ? before.LastOutcome : null,
    });

    public void Disconnected()
    {
        Change(before => MachineFacts.None with { FeedRatio = before.FeedRatio, RapidRatio = before.RapidRatio, LastAnswerTime = _time.GetUtcNow(), LastLink = before.LastLink, LastOutcome = before.LastOutcome });
        DisarmOrNotify();
    }

    /// <summary>Processes a poll; a difference from the previous one disarms.</summary>
    public void Polled(MachineReading poll)
    {
        MachineReading? before;
        lock (_guard)
        {
            if (_facts.Link is null) return;
            before = _facts.Poll;
            _facts = _facts with { Poll = poll, IsPollStale = false, LinkFailure = null, LastAnswerTime = _time.GetUtcNow() };
        }

        MachineAlarms.Polled(Alarms, poll, Profile.Axes, Link, Interlocked.Exchange(ref _ended, null));
        _isLossReported = false;
        if (before is not null && poll.DiffersFrom(before)) DisarmOrNotify();
        else _changed();
    }

    public void LinkLost(ControllerException failure)
    {
        lock (_guard)
        {
            if (_facts.Link is null) return;
            _facts = _facts with { LinkFailure = failure.Message };
        }

        if (Interlocked.Exchange(ref _ended, null) is { } ended) MachineAlarms.JobEnded(Alarms, ended, Link);
        if (!_isLossReported) MachineAlarms.LinkLost(Alarms, Link, failure.Message);
        _isLossReported = true;
        DisarmOrNotify();
    }

    /// <summary>Raises the alarm of a refused command of the operator.</summary>
    public void Refused(MachineRefusal refused)
    {
        NoteRefusal(refused.Message);
        MachineAlarms.Refused(Alarms, refused, Link);
    }

    /// <summary>Notes the refusal of a typed line. It raises no alarm, because the operator sees the answer.</summary>
    public void NoteRefusal(string text) => Change(facts => facts with { LastRefusal = text });

    public void JobStarted(bool isDryRun) => Start(facts => facts with { Progress = null, Ended = null, IsDryRun = isDryRun, MoveName = null });

    /// <summary>Notes the start of a manual move; the progress of the last job is kept.</summary>
    /// <param name="name">The displayed name of the move.</param>
    public void MoveStarted(string name) => Start(facts => facts with { MoveName = name });

    /// <summary>Notes that a feed hold or a resume was requested; the job reports when it has stopped and when it continues.</summary>
    public void FeedHoldRequested(bool held) => Change(facts => facts with { FeedHold = (facts.FeedHold, held) switch { (FeedHoldPhase.None, true) when facts.IsJobRunning => FeedHoldPhase.Braking, (FeedHoldPhase.Braking, false) => FeedHoldPhase.None, _ => facts.FeedHold } });

    /// <summary>Dismisses the last job, because another one is armed, or the drawing or the origin has changed.</summary>
    public void DismissJob() => Change(facts => facts.IsJobRunning ? facts : facts with { Progress = null, Ended = null, IsDryRun = false });

    /// <summary>Notes whether the position of the drawing's zero is known.</summary>
    /// <param name="missing">Why it is unknown and what to do; null when it is known.</param>
    public void SetOriginMissing(Diagnostic? missing) => Change(facts => facts with { OriginMissing = missing });

    /// <param name="isHomed">Null for a machine without homing.</param>
    /// <param name="isAssumed">The machine is simulated and was not homed.</param>
    public void SetHomed(bool? isHomed, bool isAssumed) => Change(facts => facts with { IsHomed = isHomed, HomingIsAssumed = isAssumed });

    private void Start(Func<MachineFacts, MachineFacts> also)
    {
        Change(facts => also(facts) with { IsJobRunning = true, IsPollStale = true, IsStopping = false, FeedHold = FeedHoldPhase.None, LastProgress = null });
        MachineAlarms.JobStarted(Alarms);
        DisarmOrNotify();
    }

    /// <summary>Notes the position of the drawing's zero.</summary>
    /// <param name="frame">Controller counts; null when unknown.</param>
    public void SetFrame(CountsPoint? frame) => Change(facts => facts with { Frame = frame });

    public void JobProgressed(JobProgress progress) => Change(facts => facts with { Progress = progress, LastProgress = progress, LastAnswerTime = _time.GetUtcNow(), FeedHold = NextFeedHold(facts.FeedHold, progress.Phase) });

    /// <summary>A requested feed hold that the job has not processed yet remains requested.</summary>
    private static FeedHoldPhase NextFeedHold(FeedHoldPhase before, JobPhase phase) => phase switch
    {
        JobPhase.Held => FeedHoldPhase.Held,
        JobPhase.Holding => FeedHoldPhase.Braking,
        JobPhase.Running when before == FeedHoldPhase.Braking => FeedHoldPhase.Braking,
        _ => FeedHoldPhase.None,
    };

    /// <summary>Takes the progress of a move by hand, and raises the change.</summary>
    public void MoveProgressed(JobProgress progress)
    {
        Change(facts => facts with { LastProgress = progress, LastAnswerTime = _time.GetUtcNow() });
        _changed();
    }

    public void JobEnded(JobResult result)
    {
        Change(facts => facts with { Frame = result.FrameOrigin ?? facts.Frame, LastRefusal = result.Refusal?.Message ?? facts.LastRefusal, LastOutcome = result.FrameOrigin is null ? facts.LastOutcome : result.Outcome, Ended = result.FrameOrigin is null ? null : result.Outcome });
        RaiseEndAlarm(result);
    }

    /// <summary>Raises the alarm of a job's end: a lost link at once, any other end after the next poll.</summary>
    private void RaiseEndAlarm(JobResult result)
    {
        if (result.Outcome != JobOutcome.LinkLost)
        {
            _ended = result;
            return;
        }

        MachineAlarms.JobEnded(Alarms, result, Link);
        _isLossReported = true;
    }

    /// <summary>Notes the end of a manual move; frame and outcome of the last job are kept.</summary>
    public void MoveEnded(JobResult result)
    {
        Change(facts => facts with { LastRefusal = result.Refusal?.Message ?? facts.LastRefusal });
        RaiseEndAlarm(result);
    }

    /// <summary>Position in the frame of the last job, or relative to the controller's zero before the first.</summary>
    public CountsPoint Position
    {
        get
        {
            lock (_guard) return _facts.Poll is { } at ? at.Position - (_facts.Frame ?? default) : default;
        }
    }

    /// <summary>Notes that no job or move is active.</summary>
    public void ClearJob() => Change(Idle);

    /// <summary>Notes that polls have ended for a motion: the last one, which may have arrived after the motion started, was read before it.</summary>
    public void WatchPaused() => Change(facts => facts with { IsPollStale = facts.IsPollStale || facts.IsJobRunning });

    /// <summary>Notes the end of a jog after which the controller is kept ready. The last poll may have been read before the jog: the position is that of the
    /// jog until the next one.</summary>
    public void ClearJog() => Change(facts => Idle(facts) with { IsPollStale = true });

    /// <summary>Notes new overrides.</summary>
    public void SetOverrides(double feed, double rapid) => Change(facts => facts with { FeedRatio = feed, RapidRatio = rapid });

    /// <summary>Notes that a stop was requested. The change is raised later by <see cref="StopSent"/>, because the stop must be sent first.</summary>
    public void StopRequested() => Change(facts => facts with { IsStopping = facts.IsJobRunning });

    /// <summary>Notes that the stop was sent.</summary>
    public void StopSent() => DisarmOrNotify();

    /// <summary>Announces a change of the session that other parts of it have made.</summary>
    public void RaiseChanged() => _changed();

    public void Dispose() => Arming.Dispose();

    private static MachineFacts Idle(MachineFacts facts) => facts with { IsJobRunning = false, IsStopping = false, FeedHold = FeedHoldPhase.None, MoveName = null };

    private void Change(Func<MachineFacts, MachineFacts> change)
    {
        lock (_guard) _facts = change(_facts);
    }

    /// <summary>Disarms, which raises the change; otherwise raises the change directly.</summary>
    private void DisarmOrNotify()
    {
        if (!Arming.Disarm()) _changed();
    }
}
