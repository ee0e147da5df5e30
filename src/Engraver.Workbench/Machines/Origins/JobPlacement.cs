using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The place of a job on a machine: found before anything moves, and kept with what the machine did.</summary>
public sealed class JobPlacement
{
    private readonly MachineHold _hold;

    private JobPlacement(MachineHold hold, PlacementResult found, MotionProgram program) => (_hold, Found, Program) = (hold, found, program);

    /// <summary>The place, or why there is none.</summary>
    public PlacementResult Found { get; }

    /// <summary>The job with the place where it finishes.</summary>
    public MotionProgram Program { get; }

    /// <summary>Whether the travel of the profile is in force, so that the controller watches it too.</summary>
    public bool KnowsTravel { get; private init; }

    /// <summary>X, Y and Z as far as steppers move them, by the controller or by the profile: their positions are those that were commanded, and nobody
    /// knows whether the motors followed.</summary>
    public IReadOnlyList<char> OpenLoop { get; private init; } = [];

    /// <summary>X, Y and Z as far as their motors are taken for steppers because nobody tells their type.</summary>
    public IReadOnlyList<char> Untold { get; private init; } = [];

    /// <summary>Asks the controller where the machine is and finds the place by the kept work origin.</summary>
    /// <param name="dryRun">The tool stays out of the work, which takes a tool that an axis holds higher.</param>
    /// <param name="time">Gives the number of the mark that is left in the controller.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="MachineMemoryException">What is found out cannot be kept.</exception>
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

    /// <summary>Notes that the machine is about to move.</summary>
    /// <exception cref="MachineMemoryException">It cannot be written down.</exception>
    public void Begin()
    {
        if (_hold.KeepMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
    }

    /// <summary>Notes the end of the motion.</summary>
    /// <returns>Null when it was written down.</returns>
    public Diagnostic? End(JobResult result) => _hold.KeepEnd(result) is { } failure ? PreparationRules.StateNotKept.At(default, failure) : null;

    /// <summary>Sets an origin at the present place, and vouches for the controller's zero from now on.</summary>
    /// <param name="set">From the machine's position, counts.</param>
    /// <returns>Why there is no certain place that an origin could be, and nothing was set; null when it was.</returns>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    internal static async Task<Diagnostic?> SetOriginAsync(IMachineConnection machine, MachineProfile profile, MachineHold hold, Func<MachineMemory, ControllerPlace, MachineMemory> set, TimeProvider time, CancellationToken cancellation)
    {
        var look = await machine.LookAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (look.Moves || look.ProgramRuns) return PreparationRules.NotSetWhileMoving.At(default); // the job of somebody else: where the machine stands in it is nobody's place
        var place = await machine.LocateAsync(profile.Axes, cancellation).ConfigureAwait(false);
        if (place.Doubt.Length > 0) return PreparationRules.NotSetWhileDoubted.At(default, place.Doubt); // it may be moved by hand before its motor holds it again
        hold.Recognise(place);
        if (WorkPlacement.NotHomed(hold.Memory, place, profile) is { } unhomed) return unhomed; // the homing that has to come first gives the counts another zero
        var knows = WorkPlacement.LossOf(hold.Memory, place) is null;
        await VouchAsync(machine, hold, place, memory => set(knows ? memory : memory.Forget(), place) with { Rest = place.Position, IsMoving = false }, time, cancellation).ConfigureAwait(false);
        return null;
    }

    /// <summary>Keeps an origin that is true by the controller's present zero, and leaves a number in a controller that has none yet, by which the next
    /// session knows that it was not switched off.</summary>
    /// <exception cref="MachineMemoryException">The controller does not take the number, or it cannot be written down; then nothing has changed.</exception>
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

    /// <summary>The motor type of the profile is set before the job moves; where it names none the controller's own stays.</summary>
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
