using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The placement of a job on a machine: determined before any motion and updated with the result of the motion.</summary>
public sealed class JobPlacement
{
    private readonly MachineHold _hold;

    private JobPlacement(MachineHold hold, PlacementResult found, MotionProgram program) => (_hold, Found, Program) = (hold, found, program);

    /// <summary>The placement, or why there is none.</summary>
    public PlacementResult Found { get; }

    /// <summary>The job with its finish position.</summary>
    public MotionProgram Program { get; }

    /// <summary>Whether the travel limits of the profile apply, so that the controller monitors them too.</summary>
    public bool KnowsTravel { get; private init; }

    /// <summary>Those of X, Y and Z that steppers move, according to controller or profile: their positions are the commanded ones, without feedback.</summary>
    public IReadOnlyList<char> OpenLoop { get; private init; } = [];

    /// <summary>Those of X, Y and Z whose motor type is unknown and which therefore count as steppers.</summary>
    public IReadOnlyList<char> Untold { get; private init; } = [];

    /// <summary>Queries the machine position and computes the placement from the stored work origin.</summary>
    /// <param name="dryRun">The tool stays off; a tool axis stays raised.</param>
    /// <param name="time">Provides the number of the mark in the controller.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="MachineMemoryException">The result cannot be stored.</exception>
    public static async Task<JobPlacement> FindAsync(IMachineConnection machine, MachineHold hold, MotionProgram program, bool dryRun, OriginRequest origin, FinishPlace finish, TimeProvider time, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(machine);
        ArgumentNullException.ThrowIfNull(hold);
        ArgumentNullException.ThrowIfNull(program);
        var place = await machine.LocateAsync(program.Profile.Axes, cancellation).ConfigureAwait(false);
        hold.Recognise(place);
        var found = WorkPlacement.Find(hold.Memory, place, origin, program.Profile, program.Start);
        if (found.Frame is { } at) found = WorkPlacement.Within(found, program with { Finish = FinishOf(program, finish, at) }, dryRun, hold.Memory, place);
        if (found.Frame is not { } frame) return new JobPlacement(hold, found, program);
        if (found.Source == OriginSource.Work) await VouchAsync(machine, hold, place, memory => found.IsAssumed ? memory.AssumeZero(program.Profile.Axes.Z is not null) : memory.UsedBy(program.Profile), time, cancellation).ConfigureAwait(false);
        return new JobPlacement(hold, found, program with { Finish = FinishOf(program, finish, frame) }) { KnowsTravel = hold.Memory.KnowsTravel(program.Profile, place), OpenLoop = OpenLoopOf(program.Profile.Axes, place), Untold = UntoldOf(program.Profile.Axes, place) };
    }

    /// <summary>Records that the machine is about to move.</summary>
    /// <exception cref="MachineMemoryException">It cannot be stored.</exception>
    public void Begin()
    {
        if (_hold.KeepMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
    }

    /// <summary>Records the end of the motion.</summary>
    /// <returns>Null on success.</returns>
    public Diagnostic? End(JobResult result) => _hold.KeepEnd(result) is { } failure ? PreparationRules.StateNotKept.At(default, failure) : null;

    /// <summary>Sets an origin at the current position and confirms the controller's zero.</summary>
    /// <param name="set">Computes the new state from the machine's position, counts.</param>
    /// <returns>Why the position is uncertain and nothing was set; null on success.</returns>
    /// <exception cref="ControllerException">The link failed, or the origin cannot be stored.</exception>
    internal static async Task<Diagnostic?> SetOriginAsync(IMachineConnection machine, MachineProfile profile, MachineHold hold, Func<MachineMemory, ControllerPlace, MachineMemory> set, TimeProvider time, CancellationToken cancellation)
    {
        var look = await machine.LookAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (look.Moves || look.ProgramRuns) return PreparationRules.NotSetWhileMoving.At(default); // Another program moves the machine: its position is temporary.
        var place = await machine.LocateAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (place.Doubt.Length > 0) return PreparationRules.NotSetWhileDoubted.At(default, place.Doubt); // It may be moved by hand before its motor is on again.
        hold.Recognise(place);
        if (WorkPlacement.NotHomed(hold.Memory, place, profile) is { } unhomed) return unhomed; // The required homing will change the zero of the counts.
        var knows = WorkPlacement.LossOf(hold.Memory, place) is null;
        await VouchAsync(machine, hold, place, memory => set(knows ? memory : memory.Forget(), place) with { Rest = place.Position, IsMoving = false }, time, cancellation).ConfigureAwait(false);
        return null;
    }

    /// <summary>Stores an origin relative to the controller's current zero, and writes a mark to a controller without one, by which the next session detects a
    /// power cycle.</summary>
    /// <exception cref="MachineMemoryException">The controller does not accept the mark, or it cannot be stored; nothing was changed.</exception>
    private static async Task VouchAsync(IMachineConnection machine, MachineHold hold, ControllerPlace place, Func<MachineMemory, MachineMemory> change, TimeProvider time, CancellationToken cancellation)
    {
        var mark = hold.Memory.Mark;
        if (hold.IsKept && !hold.Memory.IsSameZero(place))
        {
            mark = MachineMemory.NewMark(time.GetUtcNow());
            if (!await machine.MarkAsync(mark.Value, cancellation).ConfigureAwait(false)) throw new MachineMemoryException(Wording.Get("Origins.NoRoomForMark"));
        }

        if (hold.Set(memory => change(memory) with { Mark = mark, Clock = place.Clock }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        hold.Recognise(place with { Mark = mark });
    }

    /// <summary>The motor type of the profile is set before the job moves; without one the controller's setting applies.</summary>
    private static IReadOnlyList<char> OpenLoopOf(MachineAxes axes, ControllerPlace place) =>
        [.. axes.Named.Where(named => named.Axis.MotorType is null ? place.Uncounted.Contains(named.Axis.Letter, StringComparison.Ordinal) : named.Axis.IsStepper).Select(named => named.Name)];

    private static IReadOnlyList<char> UntoldOf(MachineAxes axes, ControllerPlace place) =>
        [.. axes.Named.Where(named => place.Untold.Contains(named.Axis.Letter, StringComparison.Ordinal)).Select(named => named.Name)];

    private static CountsPoint? FinishOf(MotionProgram program, FinishPlace finish, CountsPoint frame) => finish switch
    {
        FinishPlace.Origin => program.Start,
        FinishPlace.Stay => null,
        FinishPlace.Park when program.Profile.Park is { } park && program.Profile.Scale.ToCounts(park) is var at => new CountsPoint(at.X - frame.X, at.Y - frame.Y),
        FinishPlace.Park => throw new ArgumentException("The machine profile has no park position.", nameof(finish)),
        _ => throw new ArgumentOutOfRangeException(nameof(finish), finish.ToString()),
    };
}
