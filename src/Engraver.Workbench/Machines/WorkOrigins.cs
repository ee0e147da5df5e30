using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>The work origins of the connected machine, and where the active one puts a job.</summary>
public sealed class WorkOrigins
{
    private readonly ConnectedMachine _machine;
    private readonly MotionInterlock _interlock;
    private readonly MachineRuns _runs;
    private readonly MachineStatusModel _status;
    private (MachineLease Of, int? Mark, CountsPoint At)? _touch;

    internal WorkOrigins(ConnectedMachine machine, MotionInterlock interlock, MachineRuns runs, MachineStatusModel status) => (_machine, _interlock, _runs, _status) = (machine, interlock, runs, status);

    /// <summary>Where the machine is in the drawing, by the last poll or the last progress of the job, millimetres.</summary>
    /// <returns>Null where the machine's position or the place of the drawing on it is unknown.</returns>
    public Point2D? PlaceInDrawing
    {
        get
        {
            var status = _status.Status;
            if (status.State.IsJob()) return status.WorkPosition;
            return status.MachinePosition is { } at && LastPlacement(NoJob, dryRun: false)?.Frame is { } zero ? default(Point2D) + (at - NoJob.Profile.Scale.ToMillimetres(zero.X, zero.Y)) : null;
        }
    }

    /// <summary>The first of two touches, between which the machine is moved: its position by the zero from which the controller counts now; null where
    /// there was none.</summary>
    public CountsPoint? FirstTouch => _touch is { } touch && ReferenceEquals(touch.Of, _machine.Lease) && touch.Mark == touch.Of.Memory.Mark ? touch.At : null;

    private MotionProgram NoJob => new(_status.Profile, default, []);

    /// <summary>Where the active work origin puts the drawing's zero on the connected machine, by the position that the controller reports now.</summary>
    /// <returns>Null while none is connected, or while a job uses the wire.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<PlacementResult?> FindZeroAsync(CancellationToken cancellation)
    {
        await _interlock.FreeAsync().ConfigureAwait(false);
        return _machine.Watched.Watch is { } watch ? await FindAsync(watch, NoJob, dryRun: false, cancellation).ConfigureAwait(false) : null;
    }

    /// <summary>Polls the controller and finds where the active work origin puts a job; a job that would leave the travel there has no place. A failure of
    /// the link is reported by the status.</summary>
    /// <param name="program">Null where there is no job: then the place is that of the drawing's zero.</param>
    /// <param name="dryRun">The tool stays out of the work, which takes a tool on a tool axis higher.</param>
    /// <returns>Null while none is connected, while a job uses the wire, or when the link fails.</returns>
    public async Task<PlacementResult?> AskAsync(MotionProgram? program, bool dryRun, CancellationToken cancellation)
    {
        if (await _machine.FindIdleAsync().ConfigureAwait(false) is not { } watch) return null;
        try
        {
            await _machine.PollAsync(watch, cancellation).ConfigureAwait(false);
            return await FindAsync(watch, program ?? NoJob, dryRun, cancellation).ConfigureAwait(false);
        }
        catch (ControllerException failure)
        {
            _status.LinkLost(failure);
            return null;
        }
    }

    /// <summary>The same by the position of the last poll, for a list that is always shown; the controller is not asked.</summary>
    /// <returns>Null while no controller is connected, or before the first poll.</returns>
    public PlacementResult? LastPlacement(MotionProgram program, bool dryRun)
    {
        ArgumentNullException.ThrowIfNull(program);
        return LastPolled(program.Profile.Scale) is { } at ? _machine.Located?.Find(program, dryRun, at) : null;
    }

    /// <summary>Changes the work origins, with the machine's position as the controller reports it now. Disarms.</summary>
    /// <returns>Why there is no certain position for an origin; null when it was set.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed, or it cannot be stored.</exception>
    public async Task<Diagnostic?> SetAsync(Func<StoredMachineState, ControllerPosition, StoredMachineState> set, CancellationToken cancellation)
    {
        var watch = await _machine.IdleAsync().ConfigureAwait(false);
        return await SetAsync(watch, RequireLease(), set, cancellation).ConfigureAwait(false);
    }

    /// <summary>Puts a work origin at a typed position of the machine and makes it the active one. Disarms.</summary>
    /// <param name="name">One of <see cref="WorkOriginNames"/>.</param>
    /// <param name="at">The controller's own counts.</param>
    /// <param name="withHeight">The height is given; otherwise the origin keeps its own.</param>
    /// <returns>Why that position is unknown; null when it was set.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed, or it cannot be stored.</exception>
    public async Task<Diagnostic?> TypeAsync(string name, CountsPoint at, bool withHeight, CancellationToken cancellation)
    {
        var watch = await _machine.IdleAsync().ConfigureAwait(false);
        var (lease, place) = await LocateAsync(watch, cancellation).ConfigureAwait(false);
        if (WorkPlacement.PositionDoubt(lease.Memory, place, _status.Profile) is { } unknown) return unknown;
        var refusal = await SetAsync(watch, lease, (memory, _) => (memory with { Active = name }).WithOrigin(name, at.X, at.Y, withHeight ? at.Z : null, StoredAxes.Of(_status.Profile)), cancellation).ConfigureAwait(false);
        if (refusal is null && withHeight) _runs.NoteHeight();
        return refusal;
    }

    /// <summary>Chooses the work origin that jobs use from now on. Disarms.</summary>
    /// <param name="name">One of <see cref="WorkOriginNames"/>.</param>
    /// <returns>Why it could not be stored; null when it was.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    public string? Choose(string name)
    {
        var lease = RequireLease();
        if (_interlock.IsRunning) throw NotNow();
        _status.Arming.Disarm();
        var failure = lease.Commit(memory => memory with { Active = name });
        Changed();
        return failure;
    }

    /// <summary>Makes the machine's position the first touch.</summary>
    /// <returns>That position, as the controller reports it now.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<CountsPoint> TouchAsync(CancellationToken cancellation)
    {
        var watch = await _machine.IdleAsync().ConfigureAwait(false);
        var (lease, place) = await LocateAsync(watch, cancellation).ConfigureAwait(false);
        _touch = (lease, lease.Memory.Mark, place.Position);
        return place.Position;
    }

    /// <summary>The two touches were used.</summary>
    public void ForgetTouch() => _touch = null;

    /// <summary>The active origin is elsewhere, or another one: shows its new place and forgets the last job.</summary>
    internal void Changed()
    {
        if (_machine.Located is not { } located) return;
        _status.SetFrame(located.Lease.Memory.ActiveOrigin?.Plane);
        if (LastPolled(_status.Profile.Scale) is { } at) _status.SetOriginMissing(located.WhyUnplaced(_status.Profile, at));
        _runs.ForgetPlace();
    }

    private static InvalidOperationException NotNow() => new InvalidOperationException("No controller is connected, or a job runs.");

    private MachineLease RequireLease() => _machine.Lease ?? throw NotNow();

    /// <summary>The controller's own counts of the last poll.</summary>
    private CountsPoint? LastPolled(CountsScale scale)
    {
        var status = _status.Status;
        return status.MachinePosition is { } at ? scale.ToCounts(at) with { Z = scale.ToHeight(status.MachineHeight ?? 0.0) } : null;
    }

    private async Task<Diagnostic?> SetAsync(MachinePoller watch, MachineLease lease, Func<StoredMachineState, ControllerPosition, StoredMachineState> set, CancellationToken cancellation)
    {
        _status.Arming.Disarm();
        if (await watch.SetOriginAsync(_status.Profile, lease, set, cancellation).ConfigureAwait(false) is { } refusal) return refusal;
        Changed();
        return null;
    }

    private async Task<(MachineLease Lease, ControllerPosition Place)> LocateAsync(MachinePoller watch, CancellationToken cancellation) =>
        await _machine.LocateAsync(watch, cancellation).ConfigureAwait(false) is var (machine, place) ? (machine.Lease, place) : throw NotNow();

    private async Task<PlacementResult?> FindAsync(MachinePoller watch, MotionProgram program, bool dryRun, CancellationToken cancellation) =>
        await _machine.LocateAsync(watch, cancellation).ConfigureAwait(false) is var (machine, _) ? machine.Find(program, dryRun) : null;
}
