using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>The operator's controls that act at once, from any thread: stop, abort, hold, resume, and the factors of feed and rapid speed, for the job under
/// way and those that follow.</summary>
public sealed class OperatorControls
{
    private readonly Lock _guard = new();
    private readonly ConnectedMachine _machine;
    private readonly MotionInterlock _interlock;
    private readonly MachineStatusModel _status;
    private double _feed = 1.0;
    private double _rapid = 1.0;
    private JobControl? _job;

    internal OperatorControls(ConnectedMachine machine, MotionInterlock interlock, MachineStatusModel status) => (_machine, _interlock, _status) = (machine, interlock, status);

    /// <summary>The job under way is held: the machine may be moved by hand, and a resume goes back to where it was held.</summary>
    public bool IsHeld => HeldJob is not null;

    /// <summary>Of the job that is held; null when none is.</summary>
    internal JobControl? HeldJob => Job is { Phase: JobPhase.Held, IsHoldWanted: true } job ? job : null;

    private JobControl? Job
    {
        get
        {
            lock (_guard) return _job;
        }
    }

    /// <summary>Stops the job under way: the machine brakes, the tool goes off, the job ends as stopped. With no job the axes of a connected machine brake
    /// all the same. Never waits.</summary>
    /// <param name="reason">A sentence for the journal and the history, where it is not the operator's hand; null otherwise.</param>
    /// <returns>False when no job runs.</returns>
    public bool Stop(string? reason = null)
    {
        if (reason is not null && Job is { } control) control.StopReason = reason;
        var (job, watch) = HandlesToStop();
        if (job is not null) UrgentThread.Run(job.Cancel);
        else if (watch is not null) _machine.Watched.RunUrgently(watch, one => one.StopAsync(_status.Profile.OffAtStop));
        _status.StopSent();
        return job is not null;
    }

    /// <summary>Halts every motion at once, without braking, and switches the motors off; a job ends as stopped. Never waits.</summary>
    /// <remarks>On a serial line, whose one wire the job uses, a job is stopped as by <see cref="Stop"/>: its axes brake, and the motors stay as they
    /// are.</remarks>
    /// <returns>False when nothing could be sent beside a job, so that the motors stay as they are.</returns>
    public bool Abort()
    {
        var (job, watch) = HandlesToStop();
        if (watch is not null) _machine.Watched.RunUrgently(watch, one => one.AbortAsync(_status.Profile.OffAtAbort));
        if (job is not null) UrgentThread.Run(job.Cancel);
        _status.StopSent();
        return watch is not null;
    }

    /// <summary>Holds the job under way: it brakes on its path, and the tool goes off at standstill. Never waits.</summary>
    /// <returns>False when nothing runs that can be held; only a stop is possible then.</returns>
    public bool HoldJob() => Control(control => control.Hold(), held: true);

    /// <summary>Resumes a held job.</summary>
    /// <returns>False when no job is held.</returns>
    public bool ResumeJob() => Job is { IsHoldWanted: true } && Control(control => control.Resume(), held: false);

    /// <summary>Sets the factors of feed and rapid speed.</summary>
    /// <param name="feed">Null leaves it as it is.</param>
    /// <param name="rapid">Null leaves it as it is.</param>
    /// <returns>The factors in force, within their ranges.</returns>
    public (double Feed, double Rapid) Override(double? feed, double? rapid)
    {
        var (newFeed, newRapid) = Set(feed, rapid);
        _status.SetOverrides(newFeed, newRapid);
        _status.RaiseChanged();
        return (newFeed, newRapid);
    }

    /// <summary>Brakes the axes of a connected machine; a job under way is left to its own stop (<see cref="Stop"/>).</summary>
    public async Task BrakeAsync()
    {
        if (await _machine.FindIdleAsync().ConfigureAwait(false) is not null) await _machine.Watched.StopAsync(_status.Profile.OffAtStop).ConfigureAwait(false);
    }

    /// <summary>A job begins, with the factors in force.</summary>
    internal JobControl Begin()
    {
        lock (_guard) return _job = new JobControl { FeedRatio = _feed, RapidRatio = _rapid };
    }

    /// <summary>The job has ended.</summary>
    internal void End()
    {
        lock (_guard) _job = null;
    }

    private (double Feed, double Rapid) Set(double? feed, double? rapid)
    {
        lock (_guard)
        {
            var control = _job ?? new JobControl { FeedRatio = _feed, RapidRatio = _rapid };
            if (feed is { } first) control.FeedRatio = first;
            if (rapid is { } second) control.RapidRatio = second;
            return (_feed, _rapid) = (control.FeedRatio, control.RapidRatio);
        }
    }

    private bool Control(Action<JobControl> action, bool held)
    {
        if (Job is not { } control || _interlock.Stop is not { IsCancellationRequested: false }) return false;
        action(control);
        _status.FeedHoldRequested(held);
        _status.RaiseChanged();
        return true;
    }

    private (CancellationTokenSource? Job, MachinePoller? Watch) HandlesToStop()
    {
        _status.StopRequested();
        var watch = _machine.Watched.Watch;
        return (_interlock.Stop, watch); // in this order: a job that begins meanwhile is stopped as well
    }
}
