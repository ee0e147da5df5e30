using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Machines;

/// <summary>What is known of the machine, gathered from the watch and from jobs, with the alarms and the arming that follow from it. Any thread; it sends nothing.</summary>
internal sealed class MachineStatusModel : IDisposable
{
    private readonly Lock _guard = new();
    private readonly TimeProvider _time;
    private readonly Action _changed;
    private MachineFacts _facts = MachineFacts.None;
    private MachineProfile _profile = MachineProfile.Default;

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

    /// <summary>Another one disarms.</summary>
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

            DisarmOrTell();
        }
    }

    private string Link
    {
        get
        {
            lock (_guard) return _facts.Link ?? "";
        }
    }

    /// <summary>A simulated controller is a new one each time; of another one it is remembered how its last job ended.</summary>
    public void Connected(string link, bool isSimulation, MachineIdentity identity) => Change(before => new MachineFacts
    {
        Link = link,
        IsSimulation = isSimulation,
        Identity = identity,
        SeenAt = _time.GetUtcNow(),
        LastLink = link,
        LastOutcome = !isSimulation && before.LastLink == link ? before.LastOutcome : null,
    });

    public void Disconnected()
    {
        Change(before => MachineFacts.None with { SeenAt = _time.GetUtcNow(), LastLink = before.LastLink, LastOutcome = before.LastOutcome });
        DisarmOrTell();
    }

    /// <summary>The watch has looked. What differs from before disarms.</summary>
    public void Seen(MachineReading poll)
    {
        MachineReading? before;
        lock (_guard)
        {
            if (_facts.Link is null) return;
            before = _facts.Poll;
            _facts = _facts with { Poll = poll, PollIsOld = false, Lost = null, SeenAt = _time.GetUtcNow() };
        }

        MachineAlarms.Seen(Alarms, poll, Link);
        if (before is not null && poll.DiffersFrom(before)) DisarmOrTell();
        else _changed();
    }

    public void Lost(ControllerException failure)
    {
        lock (_guard)
        {
            if (_facts.Link is null) return;
            _facts = _facts with { Lost = failure.Message };
        }

        MachineAlarms.LinkLost(Alarms, Link, failure.Message);
        DisarmOrTell();
    }

    /// <summary>A command of the operator's was refused.</summary>
    public void Refused(MachineRefusal refused)
    {
        NoteRefusal(refused.Sentence);
        MachineAlarms.Refused(Alarms, refused, Link);
    }

    /// <summary>A typed line was refused: the operator sees it where it was typed, it is no alarm.</summary>
    public void NoteRefusal(string text) => Change(facts => facts with { LastRefusal = text });

    public void JobBegins() => Begins(facts => facts with { Progress = null });

    /// <summary>A move by hand begins: how far the last job came stays known.</summary>
    public void MoveBegins() => Begins(facts => facts);

    private void Begins(Func<MachineFacts, MachineFacts> also)
    {
        Change(facts => also(facts) with { JobRuns = true, PollIsOld = true, Stopping = false, Told = null });
        MachineAlarms.Begun(Alarms);
        DisarmOrTell();
    }

    /// <summary>The drawing's zero lies here.</summary>
    /// <param name="frame">Controller counts; null while nobody knows.</param>
    public void Placed(CountsPoint? frame) => Change(facts => facts with { Frame = frame });

    public void JobTells(JobProgress progress) => Change(facts => facts with { Progress = progress, Told = progress, SeenAt = _time.GetUtcNow() });

    public void MoveTells(JobProgress progress) => Change(facts => facts with { Told = progress, SeenAt = _time.GetUtcNow() });

    public void JobEnds(JobResult result)
    {
        Change(facts => facts with { Frame = result.FrameOrigin ?? facts.Frame, LastRefusal = result.Refusal?.Sentence ?? facts.LastRefusal, LastOutcome = result.Outcome });
        MachineAlarms.Ended(Alarms, result, Link);
    }

    /// <summary>A move by hand has ended: the place of the drawing and the end of the last job are as they were.</summary>
    public void MoveEnds(JobResult result)
    {
        Change(facts => facts with { LastRefusal = result.Refusal?.Sentence ?? facts.LastRefusal });
        MachineAlarms.Ended(Alarms, result, Link);
    }

    /// <summary>Where the machine stands in the frame of the last job, or by its own zero before the first.</summary>
    public CountsPoint Here
    {
        get
        {
            lock (_guard) return _facts.Poll is { } at ? new CountsPoint(at.X - (_facts.Frame?.X ?? 0), at.Y - (_facts.Frame?.Y ?? 0)) : default;
        }
    }

    /// <summary>The machine is nobody's again.</summary>
    public void JobIsOver() => Change(facts => facts with { JobRuns = false, Stopping = false });

    /// <summary>A stop is asked for. Nobody is told yet: the stop itself comes first (<see cref="StopSent"/>).</summary>
    public void StopAsked() => Change(facts => facts with { Stopping = facts.JobRuns });

    /// <summary>The stop is on its way.</summary>
    public void StopSent() => DisarmOrTell();

    public void Dispose() => Arming.Dispose();

    private void Change(Func<MachineFacts, MachineFacts> change)
    {
        lock (_guard) _facts = change(_facts);
    }

    /// <summary>Disarming tells by itself.</summary>
    private void DisarmOrTell()
    {
        if (!Arming.Disarm()) _changed();
    }
}
