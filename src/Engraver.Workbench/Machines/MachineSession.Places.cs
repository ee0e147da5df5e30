using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that knows where the work is: the work origins, and where the active one puts a job.</summary>
public sealed partial class MachineSession
{
    /// <summary>Where the active work origin puts the drawing's zero on the connected machine, by the position that the controller reports now.</summary>
    /// <returns>Null while none is connected, or while a job has the wire.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<PlacementResult?> FindZeroAsync(CancellationToken cancellation) => PlaceAsync(NoJob, dryRun: false, cancellation);

    /// <summary>Looks at the controller now and finds where the active work origin puts a job; a job that would leave the travel there has no place. That
    /// nobody answers is told by the status.</summary>
    /// <param name="program">Null where there is no job: then the place is that of the drawing's zero.</param>
    /// <param name="dryRun">The tool stays out of the work, which takes a tool that an axis holds higher.</param>
    /// <returns>Null while none is connected, while a job has the wire, or when nobody answers.</returns>
    public async Task<PlacementResult?> AskAsync(MotionProgram? program, bool dryRun, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || IsRunning) return null;
        try
        {
            Seen(await watch.LookAsync(cancellation).ConfigureAwait(false));
            return await PlaceAsync(program ?? NoJob, dryRun, cancellation).ConfigureAwait(false);
        }
        catch (ControllerException failure)
        {
            _status.Lost(failure);
            return null;
        }
    }

    /// <summary>The same by the position that the watch saw last, for a list that is always shown; the controller is not asked.</summary>
    /// <returns>Null while no controller is connected, or before it was looked at.</returns>
    public PlacementResult? LastPlacement(MotionProgram program, bool dryRun)
    {
        ArgumentNullException.ThrowIfNull(program);
        var scale = program.Profile.Scale;
        return Status.MachinePosition is { } at ? LastPlacement(program, dryRun, scale.ToCounts(at) with { Z = scale.ToHeight(Status.MachineHeight ?? 0.0) }) : null;
    }

    /// <summary>Where the machine is in the drawing, by what the watch or the job told last, millimetres.</summary>
    /// <returns>Null where nobody knows the machine's place, or where the drawing lies on it.</returns>
    public Point2D? PlaceInDrawing
    {
        get
        {
            var status = Status;
            if (status.State.IsJob()) return status.WorkPosition;
            return status.MachinePosition is { } at && LastPlacement(NoJob, dryRun: false)?.Frame is { } zero ? default(Point2D) + (at - Profile.Scale.ToMillimetres(zero.X, zero.Y)) : null;
        }
    }

    /// <summary>Changes the work origins, with the machine's position as the controller tells it now. Disarms.</summary>
    /// <returns>Why there is no certain place that an origin could be; null when it was set.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    public async Task<Diagnostic?> SetOriginAsync(Func<MachineMemory, ControllerPlace, MachineMemory> set, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        if (await watch.SetOriginAsync(Profile, hold, set, cancellation).ConfigureAwait(false) is { } refusal) return refusal;
        OriginChanged(hold);
        return null;
    }

    /// <summary>Puts a work origin at a typed place of the machine and makes it the active one. Disarms.</summary>
    /// <param name="name">One of <see cref="WorkOriginNames"/>.</param>
    /// <param name="at">The controller's own counts.</param>
    /// <param name="withHeight">The height is given; otherwise the origin keeps its own.</param>
    /// <returns>Why nobody knows where that is; null when it was set.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    public async Task<Diagnostic?> TypeOriginAsync(string name, CountsPoint at, bool withHeight, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        var place = _place = await watch.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
        hold.Recognise(place);
        if (WorkPlacement.WhyNotKnown(hold.Memory, place, Profile) is { } unknown) return unknown;
        return await SetOriginAsync((memory, _) => (memory with { Active = name }).WithOrigin(name, at.X, at.Y, withHeight ? at.Z : null, KeptAxes.Of(Profile)), cancellation).ConfigureAwait(false);
    }

    /// <summary>Chooses the work origin that jobs use from now on. Disarms.</summary>
    /// <param name="name">One of <see cref="WorkOriginNames"/>.</param>
    /// <returns>Why it could not be kept; null when it was.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    public string? ChooseOrigin(string name)
    {
        if (Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        var failure = hold.Set(memory => memory with { Active = name });
        OriginChanged(hold);
        return failure;
    }

    private MotionProgram NoJob => new(Profile, default, []);

    private async Task<PlacementResult?> PlaceAsync(MotionProgram program, bool dryRun, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || Hold is not { } hold) return null;
        var place = _place = await watch.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
        hold.Recognise(place);
        return Placed(program, dryRun, hold.Memory, place);
    }

    private static PlacementResult Placed(MotionProgram program, bool dryRun, MachineMemory memory, ControllerPlace place)
    {
        var found = WorkPlacement.Find(memory, place, new OriginRequest.Work(), program.Profile, program.Start);
        return program.Strokes.Count == 0 ? found : WorkPlacement.Within(found, program, dryRun, memory, place);
    }

    private PlacementResult? LastPlacement(MotionProgram program, bool dryRun, CountsPoint at) => _place is { } place && Hold is { } hold
        ? Placed(program, dryRun, hold.Memory, place with { Mark = hold.KnowsZero ? hold.Memory.Mark : null, Clock = null, Position = at })
        : null;

    /// <summary>Takes the new place of the drawing's zero and forgets the last job, which was cut elsewhere, and what START should cut of it.</summary>
    private void OriginChanged(MachineHold hold)
    {
        Part = null;
        _status.Placed(hold.Memory.ActiveOrigin?.Plane);
        if (Status.MachinePosition is { } at) _status.OriginIs(OriginMissing(Profile.Scale.ToCounts(at) with { Z = Profile.Scale.ToHeight(Status.MachineHeight ?? 0.0) }));
        DismissJob();
    }

    /// <summary>Why the active origin gives no place for a job, by what the watch saw; null when it gives one.</summary>
    private Diagnostic? OriginMissing(CountsPoint at) => LastPlacement(NoJob, dryRun: false, at)?.Refusal;
}
