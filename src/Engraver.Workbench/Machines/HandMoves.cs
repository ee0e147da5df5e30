using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>What the operator does to the connected machine by hand: jog, go to a position, home, and switch motors and outputs.</summary>
public sealed class HandMoves
{
    private readonly ConnectedMachine _machine;
    private readonly WorkOrigins _origins;
    private readonly OperatorControls _controls;
    private readonly MachineStatusModel _status;
    private readonly MachineTrail _trail;
    private readonly TimeProvider _time;

    internal HandMoves(ConnectedMachine machine, WorkOrigins origins, OperatorControls controls, MachineStatusModel status, MachineTrail trail, TimeProvider time)
    {
        (_machine, _origins, _controls, _status, _trail, _time) = (machine, origins, controls, status, trail, time);
        Presence = new OperatorPresence(time, status.RaiseChanged);
    }

    /// <summary>Begins continuous jogs, and receives the signs of life of the front end during them.</summary>
    public OperatorPresence Presence { get; }

    /// <summary>The names of the work origins that a homing would lose now.</summary>
    public IReadOnlyList<string> OriginsLostByHoming => _machine.Lease is { } lease ? MachineHoming.OriginsLost(lease.Memory, lease.IsZeroKnown, _status.Profile) : [];

    /// <summary>The notice before a move by hand on a machine that is not homed; null for any other.</summary>
    public string? UnhomedNotice => _machine.IsHomed == false ? Wording.Get("HandMoves.NotHomed", HandSpeed.Max(_status.Profile, isHomed: false)) : null;

    /// <summary>Moves the connected machine as long as a key is held, tool off, and disarms; also while a job is held. It brakes when the jog is released or
    /// the operator gives no signs of life (<see cref="Presence"/>), by a stop, and 0.25 s after the last sign of this program.</summary>
    /// <param name="jog">Started by <see cref="Presence"/> when the key went down.</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    /// <returns>How it ended; complete when it was released or came to the end of the travel.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> JogAsync(ContinuousJog jog, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(jog);
        await _machine.FreeAsync().ConfigureAwait(false);
        if (_controls.HeldJob is { } held)
        {
            await using var released = cancellation.UnsafeRegister(key => ((ContinuousJog)key!).Release(), jog).ConfigureAwait(false);
            return await held.MoveAsync(MoveInHold.While(jog.Control)).ConfigureAwait(false);
        }

        return await _machine.MoveAsync(_status.Profile, MachineMove.Jog(jog.Control, journal, new JobListener(_status.MoveProgressed)), cancellation).ConfigureAwait(false);
    }

    /// <summary>Moves the connected machine with the tool off, at the profile's rapid speed, and disarms. It is stopped as a job is. A tool on a tool axis
    /// moves up to its clearance height over the work first; where the height of the work is unknown the move is refused.</summary>
    /// <param name="goal">The controller's own counts, in plan.</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    /// <param name="feed">Speed of each axis, mm/min; null for the profile's rapid speed.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<JobResult> GoToAsync(CountsPoint goal, string journal, double? feed, CancellationToken cancellation)
    {
        var profile = WithFeed(feed);
        return _machine.MoveAsync(profile, MachineMove.GoTo(goal, profile, journal, new JobListener(_status.MoveProgressed)), cancellation);
    }

    /// <summary>Moves the connected machine by a step, as <see cref="GoToAsync"/> does; also a machine that is not homed, which has no travel then and moves
    /// slowly (<see cref="HandSpeed"/>), and while a job is held.</summary>
    /// <param name="goal">The end of the step, the controller's own counts.</param>
    /// <param name="withHeight">The step moves up or down too.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> StepAsync(CountsPoint goal, bool withHeight, string journal, double? feed, CancellationToken cancellation)
    {
        await _machine.FreeAsync().ConfigureAwait(false);
        if (_controls.HeldJob is { } held) return await held.MoveAsync(MoveInHold.To(goal, withHeight, feed)).ConfigureAwait(false);
        var profile = WithFeed(feed);
        return await _machine.MoveAsync(profile, MachineMove.To(goal, withHeight, isStep: true, profile, journal, new JobListener(_status.MoveProgressed)), cancellation).ConfigureAwait(false);
    }

    /// <summary>Homes the connected machine as its profile configures, tool off, and disarms. It is stopped as a job is.</summary>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up, or what is known of the machine cannot be stored.</exception>
    public async Task<MachineHomingResult> HomeAsync(string journal, CancellationToken cancellation)
    {
        await _machine.FreeAsync().ConfigureAwait(false);
        IReadOnlyList<string> forgotten = [];
        var profile = _status.Profile;
        _trail.IsHoming = true;
        try
        {
            var result = await _machine.MoveAsync(
                Wording.Get("MachineSession.Homing"),
                async (connection, stop) =>
                {
                    var homed = await MachineHoming.RunAsync(connection, _machine.Lease!, profile, _status.Position, journal, new JobListener(_status.MoveProgressed), _time, stop).ConfigureAwait(false);
                    forgotten = homed.LostOrigins;
                    return homed.Result;
                },
                cancellation).ConfigureAwait(false);
            _origins.Changed(); // its counts may be different now
            return new MachineHomingResult(result, forgotten);
        }
        finally
        {
            _trail.IsHoming = false;
        }
    }

    /// <summary>Switches an output of the connected machine by hand. Outputs that work on the material are only switched off: the controller would not
    /// switch them off if this program crashed.</summary>
    /// <param name="output">From 1.</param>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, a job runs, or the tool would be switched on.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation)
    {
        if (_status.Profile.IsForJobsOnly(output, on)) throw new InvalidOperationException("The tool would be switched on.");
        return await SwitchAsync(watch => watch.SetOutputAsync(output, on, cancellation), cancellation).ConfigureAwait(false);
    }

    /// <summary>Switches the motors of all axes on or off.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<MachineRefusal?> SetMotorsAsync(bool on, CancellationToken cancellation) => SwitchAsync(watch => watch.SetMotorsAsync(on, cancellation), cancellation);

    private async Task<MachineRefusal?> SwitchAsync(Func<MachinePoller, Task<MachineRefusal?>> change, CancellationToken cancellation)
    {
        var watch = await _machine.IdleAsync().ConfigureAwait(false);
        _status.Arming.Disarm();
        var refused = await change(watch).ConfigureAwait(false);
        if (refused is not null) _status.Refused(refused);
        await _machine.PollAsync(watch, cancellation).ConfigureAwait(false);
        return refused;
    }

    private MachineProfile WithFeed(double? feed) => feed is { } speed ? _status.Profile with { RapidMmPerMinute = speed } : _status.Profile;
}
