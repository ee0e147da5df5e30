using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that moves the machine by hand, homes it and switches its outputs.</summary>
public sealed partial class MachineSession
{
    /// <summary>A job stands held: the machine may be moved by hand, and a resume goes back to where it was held.</summary>
    public bool IsHeld => _overrides.Control is { Phase: JobPhase.Held, IsHoldWanted: true };

    /// <summary>Moves the connected machine as long as a key is held, tool off, and disarms; also while a job stands held. It brakes when the jog is
    /// released or the operator is not heard of any more (<see cref="Presence"/>), by a stop, and 0.25 s after this program was heard last.</summary>
    /// <param name="jog">Begun by <see cref="Presence"/> when the key went down.</param>
    /// <param name="journal">Where what is found in the controller is written down.</param>
    /// <returns>How it ended; complete when it was released or came to the end of the travel.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> JogAsync(HeldJog jog, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(jog);
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        if (IsHeld && _overrides.Control is { } held)
        {
            await using var released = cancellation.UnsafeRegister(key => ((HeldJog)key!).Release(), jog).ConfigureAwait(false);
            return await held.MoveAsync(HeldMove.While(jog.Control)).ConfigureAwait(false);
        }

        return await _work.RunAsync(stop => MoveWatchedAsync(connection, Profile, MachineMove.Jog(jog.Control, journal, new JobListener(TellMove)), stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Moves the connected machine with the tool off, at the profile's rapid speed, and disarms. It is stopped as a job is. A tool that an axis
    /// holds goes up to its clearance height over the work first; where nobody knows the height of the work the move is refused.</summary>
    /// <param name="goal">The controller's own counts, in plan.</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    /// <param name="feed">Speed of each axis, mm/min; null for the profile's rapid speed.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<JobResult> GoToAsync(CountsPoint goal, string journal, double? feed, CancellationToken cancellation) =>
        MoveToAsync(goal, withHeight: false, isStep: false, journal, feed, cancellation);

    /// <summary>Moves the connected machine by a step, as <see cref="GoToAsync"/> does; also a machine that is not homed, which has no travel then and goes
    /// slowly (<see cref="HandSpeed"/>), and while a job stands held.</summary>
    /// <param name="goal">Where the step ends, the controller's own counts.</param>
    /// <param name="withHeight">The step goes up or down too.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<JobResult> StepAsync(CountsPoint goal, bool withHeight, string journal, double? feed, CancellationToken cancellation) => MoveToAsync(goal, withHeight, isStep: true, journal, feed, cancellation);

    private async Task<JobResult> MoveToAsync(CountsPoint goal, bool withHeight, bool isStep, string journal, double? feed, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        if (isStep && IsHeld && _overrides.Control is { } held) return await held.MoveAsync(HeldMove.To(goal, withHeight, feed)).ConfigureAwait(false);
        var profile = feed is { } speed ? Profile with { RapidMmPerMinute = speed } : Profile;
        var listener = new JobListener(TellMove);
        var move = isStep ? MachineMove.To(goal, withHeight, isStep, profile, journal, listener) : MachineMove.GoTo(goal, profile, journal, listener);
        return await _work.RunAsync(stop => MoveWatchedAsync(connection, profile, move, stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Homes the connected machine as its profile says, tool off, and disarms. It is stopped as a job is.</summary>
    /// <param name="journal">Where what is found in the controller is written down.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up, or what is known of the machine cannot be written down.</exception>
    public async Task<HomedMachine> HomeAsync(string journal, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        IReadOnlyList<string> forgotten = [];
        var profile = Profile;
        async Task<JobResult> Home(CancellationToken stop)
        {
            var homed = await MachineHoming.RunAsync(connection, Hold!, profile, _status.Here, journal, new JobListener(TellMove), _time, stop).ConfigureAwait(false);
            forgotten = homed.Forgotten;
            return homed.Result;
        }

        Trail.IsHoming = true;
        try
        {
            var result = await _work.RunAsync(stop => WatchedAsync(connection, Wording.Get("MachineSession.Homing"), () => Home(stop)), cancellation).ConfigureAwait(false);
            if (Hold is { } hold) OriginChanged(hold); // its counts may be others now
            return new HomedMachine(result, forgotten);
        }
        finally
        {
            Trail.IsHoming = false;
        }
    }

    /// <summary>Switches an output of the connected machine by hand. What works on the material is only switched off: nothing in the controller would do it
    /// if this program died.</summary>
    /// <param name="output">From 1.</param>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, a job runs, or the tool would be switched on.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || IsRunning || Profile.IsForJobsOnly(output, on)) throw new InvalidOperationException("No controller is connected, a job runs, or the tool would be switched on.");
        Disarm();
        var refused = await watch.SetOutputAsync(output, on, cancellation).ConfigureAwait(false);
        if (refused is not null) _status.Refused(refused);
        Seen(await watch.LookAsync(cancellation).ConfigureAwait(false));
        return refused;
    }

    /// <summary>The names of the work origins that a homing would lose now.</summary>
    public IReadOnlyList<string> HomingForgets => Hold is { } hold ? MachineHoming.WouldLose(hold.Memory, hold.KnowsZero, Profile) : [];

    /// <summary>What the operator is told before a move by hand on a machine that is not homed; null for any other.</summary>
    public string? UnhomedNotice => IsHomed == false ? Wording.Get("HandMotion.NotHomed", HandSpeed.Fastest(Profile, isHomed: false)) : null;

    /// <summary>Whether the machine is homed; null for one without homing, or while none is connected.</summary>
    public bool? IsHomed => Profile.HasHoming && Hold is { } hold ? hold.IsHomed(Profile) : null;
}
