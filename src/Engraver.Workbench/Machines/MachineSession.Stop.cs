using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that acts at once, from any thread: stop, abort, hold, resume and overrides; and the motors.</summary>
public sealed partial class MachineSession
{
    /// <summary>Stops the job under way: the machine brakes, the tool goes off, the job ends as stopped. With no job the axes of a connected machine brake
    /// all the same. Never waits, from any thread.</summary>
    /// <param name="reason">Why, a sentence for the journal and the history, where it is not the operator's hand; null otherwise.</param>
    /// <returns>False when no job runs.</returns>
    public bool Stop(string? reason = null)
    {
        if (reason is not null && _overrides.Control is { } control) control.StopReason = reason;
        var (job, watch) = AtWork();
        if (job is not null) UrgentThread.Run(job.Cancel);
        else if (watch is not null) _watched.ActUrgently(watch, one => one.StopAsync(Profile.OffAtStop));
        _status.StopSent();
        return job is not null;
    }

    /// <summary>Halts every motion at once, without braking, and switches the motors off; a job ends as stopped. Never waits, from any thread.</summary>
    /// <remarks>On a serial line, whose one wire the job uses, a job is stopped as by <see cref="Stop"/>: its axes brake, and the motors stay as they
    /// are.</remarks>
    /// <returns>False when nothing could be sent beside a job, so that the motors stay as they are.</returns>
    public bool Abort()
    {
        var (job, watch) = AtWork();
        if (watch is not null) _watched.ActUrgently(watch, one => one.AbortAsync(Profile.OffAtAbort));
        if (job is not null) UrgentThread.Run(job.Cancel);
        _status.StopSent();
        return watch is not null;
    }

    /// <summary>Holds the job under way: it brakes on its path, and the tool goes off once it stands. Never waits, from any thread.</summary>
    /// <returns>False when nothing runs that can be held; a stop is what is left then.</returns>
    public bool HoldJob() => Control(control => control.Hold(), held: true);

    /// <summary>Lets a held job go on.</summary>
    /// <returns>False when no job is held.</returns>
    public bool ResumeJob() => _overrides.Control is { IsHoldWanted: true } && Control(control => control.Resume(), held: false);

    /// <summary>Factors of feed and rapid speed for the job under way and those that follow.</summary>
    /// <param name="feed">Null leaves it as it is.</param>
    /// <param name="rapid">Null leaves it as it is.</param>
    /// <returns>What is asked for now.</returns>
    public (double Feed, double Rapid) Override(double? feed, double? rapid)
    {
        var set = _overrides.Set(feed, rapid);
        _status.Overridden(set.Feed, set.Rapid);
        RaiseChanged();
        return set;
    }

    /// <summary>Switches the motors of both axes on or off.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<MachineRefusal?> SetMotorsAsync(bool on, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        var refused = await watch.SetMotorsAsync(on, cancellation).ConfigureAwait(false);
        if (refused is not null) _status.Refused(refused);
        Seen(await watch.LookAsync(cancellation).ConfigureAwait(false));
        return refused;
    }

    /// <summary>Brakes the axes of a connected machine; a job under way is left to its own stop (<see cref="Stop"/>).</summary>
    public async Task BrakeAsync()
    {
        await FreeAsync().ConfigureAwait(false);
        if (!IsRunning) await _watched.StopAsync(Profile.OffAtStop).ConfigureAwait(false);
    }

    private bool Control(Action<JobControl> act, bool held)
    {
        if (_overrides.Control is not { } control || _work.Stop is not { IsCancellationRequested: false }) return false;
        act(control);
        _status.HoldAsked(held);
        RaiseChanged();
        return true;
    }

    private (CancellationTokenSource? Job, MachineWatch? Watch) AtWork()
    {
        _status.StopAsked();
        var watch = _watched.Watch;
        return (_work.Stop, watch); // in this order: a job that begins meanwhile is stopped as well
    }
}
