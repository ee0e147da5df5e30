using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The placement of a job on a machine: determined before any motion and updated with the result of the motion.</summary>
public sealed class JobPlacement
{
    private readonly MachineLease _lease;

    private JobPlacement(MachineLease lease, PlacementResult found, MotionProgram program) => (_lease, Found, Program) = (lease, found, program);

    /// <summary>The placement, or why there is none.</summary>
    public PlacementResult Found { get; }

    /// <summary>The job with its finish position.</summary>
    public MotionProgram Program { get; }

    /// <summary>Whether the travel limits of the profile apply, so that the controller monitors them too.</summary>
    public bool KnowsTravel { get; private init; }

    /// <summary>Those of X, Y and Z that steppers move, according to controller or profile: their positions are the commanded ones, without feedback.</summary>
    public IReadOnlyList<char> OpenLoop { get; private init; } = [];

    /// <summary>Those of X, Y and Z whose motor type is unknown and which therefore count as steppers.</summary>
    public IReadOnlyList<char> UnknownMotorTypes { get; private init; } = [];

    /// <summary>Queries the machine position and computes the placement from the stored work origin.</summary>
    /// <param name="dryRun">The tool stays off; a tool axis stays raised.</param>
    /// <param name="following">The jobs after it; null for none.</param>
    /// <param name="time">Provides the number of the mark in the controller.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="MachineMemoryException">The result cannot be stored.</exception>
    public static async Task<JobPlacement> FindAsync(IMachineConnection machine, MachineLease lease, MotionProgram program, bool dryRun, OriginRequest origin, FinishPlace finish, FollowingJobs? following, TimeProvider time, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(machine);
        ArgumentNullException.ThrowIfNull(lease);
        ArgumentNullException.ThrowIfNull(program);
        var place = await machine.ReadPositionAsync(program.Profile.Axes, cancellation).ConfigureAwait(false);
        lease.CompareZero(place);
        var memory = origin is OriginRequest.NamedOrigin && lease.IsPersistent ? lease.Memory.WithoutAssumed() : lease.Memory; // a fixture of a real machine was set by the operator
        var found = WorkPlacement.Find(memory, place, origin, program.Profile, program.Start);
        if (found.Frame is { } at) found = WorkPlacement.Within(found, program with { Finish = FinishOf(program, finish, at) }, dryRun, memory, place, following?.Here);
        if (found.Frame is not null && following is not null) found = WorkPlacement.Followed(found, origin, following, program.Profile, dryRun, memory, place);
        if (found.Frame is not { } frame) return new JobPlacement(lease, found, program);
        if (found.Source == OriginSource.Work) await ConfirmZeroAsync(machine, lease, place, memory => Used(memory, origin, found, program.Profile), time, cancellation).ConfigureAwait(false);
        return new JobPlacement(lease, found, program with { Finish = FinishOf(program, finish, frame) }) { KnowsTravel = lease.Memory.IsTravelKnown(program.Profile, place), OpenLoop = OpenLoopOf(program.Profile.Axes, place), UnknownMotorTypes = UnknownMotorTypesOf(program.Profile.Axes, place) };
    }

    /// <summary>The memory after an origin was used by a job.</summary>
    private static StoredMachineState Used(StoredMachineState memory, OriginRequest origin, PlacementResult found, MachineProfile profile)
    {
        if (origin is OriginRequest.NamedOrigin { Name: var name }) return memory.UsedBy(profile, name);
        return found.IsAssumed ? memory.AssumeZero(profile.Axes.Z is not null) : memory.UsedBy(profile);
    }

    /// <summary>Records that the machine is about to move.</summary>
    /// <exception cref="MachineMemoryException">It cannot be stored.</exception>
    public void NoteStart()
    {
        if (_lease.NoteMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
    }

    /// <summary>Records the end of the motion.</summary>
    /// <returns>Null on success.</returns>
    public Diagnostic? NoteEnd(JobResult result) => _lease.NoteMotionEnd(result) is { } failure ? PreparationRules.StateNotKept.At(default, failure) : null;

    /// <summary>Sets an origin at the current position and confirms the controller's zero.</summary>
    /// <param name="set">Computes the new state from the machine's position, counts.</param>
    /// <returns>Why the position is uncertain and nothing was set; null on success.</returns>
    /// <exception cref="ControllerException">The link failed, or the origin cannot be stored.</exception>
    internal static async Task<Diagnostic?> SetOriginAsync(IMachineConnection machine, MachineProfile profile, MachineLease lease, Func<StoredMachineState, ControllerPosition, StoredMachineState> set, TimeProvider time, CancellationToken cancellation)
    {
        var look = await machine.ReadStatusAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (look.IsMoving || look.IsProgramRunning) return PreparationRules.NotSetWhileMoving.At(default); // Another program moves the machine: its position is temporary.
        var place = await machine.ReadPositionAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (place.Doubt.Length > 0) return PreparationRules.NotSetWhileDoubted.At(default, place.Doubt); // It may be moved by hand before its motor is on again.
        lease.CompareZero(place);
        if (WorkPlacement.NotHomed(lease.Memory, place, profile) is { } unhomed) return unhomed; // The required homing will change the zero of the counts.
        var knows = WorkPlacement.ZeroDoubt(lease.Memory, place) is null;
        await ConfirmZeroAsync(machine, lease, place, memory => set(knows ? memory : memory.Forget(), place) with { RestPosition = place.Position, IsMoving = false }, time, cancellation).ConfigureAwait(false);
        return null;
    }

    /// <summary>Stores an origin relative to the controller's current zero, and writes a mark to a controller without one, by which the next session detects a
    /// power cycle.</summary>
    /// <exception cref="MachineMemoryException">The controller does not accept the mark, or it cannot be stored; nothing was changed.</exception>
    private static async Task ConfirmZeroAsync(IMachineConnection machine, MachineLease lease, ControllerPosition place, Func<StoredMachineState, StoredMachineState> change, TimeProvider time, CancellationToken cancellation)
    {
        var mark = lease.Memory.Mark;
        if (lease.IsPersistent && !lease.Memory.IsSameZero(place))
        {
            mark = StoredMachineState.NewMark(time.GetUtcNow());
            if (!await machine.StoreMarkAsync(mark.Value, cancellation).ConfigureAwait(false)) throw new MachineMemoryException(Wording.Get("Origins.NoRoomForMark"));
        }

        if (lease.Commit(memory => change(memory) with { Mark = mark, Clock = place.Clock }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        lease.CompareZero(place with { Mark = mark });
    }

    /// <summary>The motor type of the profile is set before the job moves; without one the controller's setting applies.</summary>
    private static IReadOnlyList<char> OpenLoopOf(MachineAxes axes, ControllerPosition place) =>
        [.. axes.Named.Where(named => named.Axis.MotorType is null ? place.WithoutEncoder.Contains(named.Axis.Letter, StringComparison.Ordinal) : named.Axis.IsStepper).Select(named => named.Name)];

    private static IReadOnlyList<char> UnknownMotorTypesOf(MachineAxes axes, ControllerPosition place) =>
        [.. axes.Named.Where(named => place.AssumedSteppers.Contains(named.Axis.Letter, StringComparison.Ordinal)).Select(named => named.Name)];

    private static CountsPoint? FinishOf(MotionProgram program, FinishPlace finish, CountsPoint frame) => finish switch
    {
        FinishPlace.Origin => program.Start,
        FinishPlace.Stay => null,
        FinishPlace.Park when program.Profile.Park is { } park && program.Profile.Scale.ToCounts(park) is var at => new CountsPoint(at.X - frame.X, at.Y - frame.Y),
        FinishPlace.Park => throw new ArgumentException("The machine profile has no park position.", nameof(finish)),
        _ => throw new ArgumentOutOfRangeException(nameof(finish), finish.ToString()),
    };
}
