using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Compares the speed of the path (_VMS, in every poll) with the planned speed times the ratio that the job sent: VS, VR and VA act in motion,
/// whichever host or program sets them (galil-dmc.md B.4).</summary>
/// <remarks>
/// Too fast: 5 % above, in two polls in a row. After the job itself lowers the ratio the path brakes at VD; the limit follows at half of that rate.
/// Too slow: below half of the plan for half a second with the tool on. A speed that changes by at least half of the planned acceleration is a ramp.
/// Measured in controller time, so that a slow host changes nothing.
/// </remarks>
internal sealed class FeedWatch(JobMachine machine)
{
    private const double MaxShare = 1.05;
    private const double MinShare = 0.5;

    /// <summary>_VMS is a whole number, and VS is kept in steps of 2, counts/s.</summary>
    private const double Resolution = 4.0;

    private const int FastPolls = 2;
    private const double SlowSeconds = 0.5;

    /// <summary>Shortest time over which a change of speed is judged, seconds: speed and TIME are read a sample or two apart.</summary>
    private const double RampWindowSeconds = 0.02;

    private int _fastInARow;
    private double _ceiling;
    private double _ratio;
    private int _calls;
    private bool _isFollowing;

    /// <summary>Half of the planned acceleration, counts/s2.</summary>
    private double _ramp;
    private (double Seconds, double Speed) _last;
    private (double Seconds, double Speed) _window;
    private double? _slowSince;

    /// <summary>Operands of settings that another host or program has changed: they are left as they are.</summary>
    public IReadOnlyList<string> SetByOthers { get; set; } = [];

    /// <summary>Call with each poll.</summary>
    /// <returns>Whether the speed of the path cannot be the job's own.</returns>
    public bool IsForeign()
    {
        if (machine is { State.SequenceRunning: true, Hold.Phase: JobPhase.Running, Speed.Ratio: > 0.0 and var ratio } && machine.Phase.Speed?.Invoke(machine.State) is { } planned) return IsForeign(machine.State, machine.Seconds, planned, ratio);
        _isFollowing = false; // the next poll begins again
        return false;
    }

    private bool IsForeign(in JobPoll state, double seconds, PlannedSpeed planned, double ratio)
    {
        if (!_isFollowing || state.Calls != _calls) Begin(state, seconds, planned.Highest * ratio, ratio);
        Follow(seconds, planned, ratio);
        var isFast = IsFast(state.PathSpeed, seconds);
        var isSlow = IsSlow(state.PathSpeed, seconds, planned.Lowest * ratio);
        _last = (seconds, state.PathSpeed);
        return isFast || isSlow;
    }

    private void Begin(in JobPoll state, double seconds, double target, double ratio)
    {
        (_isFollowing, _calls, _fastInARow, _ceiling, _ratio) = (true, state.Calls, 0, target, ratio);
        (_last, _window, _slowSince) = ((seconds, state.PathSpeed), (seconds, state.PathSpeed), null);
    }

    /// <summary>A ratio that was sent since the last poll may not act yet.</summary>
    private void Follow(double seconds, PlannedSpeed planned, double ratio)
    {
        var target = planned.Highest * ratio;
        _ramp = planned.LowestAcceleration / 2.0;
        if (target >= _ceiling) _ceiling = target;
        else if (ratio == _ratio) _ceiling = Math.Max(target, _ceiling - (_ramp * (seconds - _last.Seconds)));
        if (ratio != _ratio) _slowSince = null;
        _ratio = ratio;
    }

    private bool IsFast(double speed, double seconds)
    {
        if (speed <= (_ceiling * MaxShare) + Resolution) _fastInARow = 0;
        else if (seconds > _last.Seconds || _fastInARow == 0) _fastInARow++;
        return _fastInARow >= FastPolls;
    }

    private bool IsSlow(double speed, double seconds, double target)
    {
        if (speed >= (target * MinShare) - Resolution || !machine.IsToolOn || IsRamp(speed, seconds)) _slowSince = null;
        else _slowSince ??= seconds;
        return seconds - _slowSince >= SlowSeconds;
    }

    private bool IsRamp(double speed, double seconds)
    {
        var passed = seconds - _window.Seconds;
        if (passed < RampWindowSeconds) return false;
        var change = Math.Abs(speed - _window.Speed);
        _window = (seconds, speed);
        return change >= _ramp * passed;
    }
}
