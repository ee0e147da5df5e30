using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Where a job goes on a machine: found before anything moves, and kept with what the machine did.</summary>
public sealed class JobPlacement
{
    private readonly MachineHold _hold;
    private readonly ControllerPlace _place;

    private JobPlacement(MachineHold hold, ControllerPlace place, PlacementResult found, MotionProgram program) => (_hold, _place, Found, Program) = (hold, place, found, program);

    /// <summary>The place, or why there is none.</summary>
    public PlacementResult Found { get; }

    /// <summary>The job with the place where it finishes.</summary>
    public MotionProgram Program { get; }

    /// <summary>Asks the machine where it is and finds the place by what is kept.</summary>
    /// <param name="time">Where the mark that is left in the controller takes its number from.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="MachineMemoryException">What is found out cannot be kept.</exception>
    public static async Task<JobPlacement> FindAsync(IMachineConnection machine, MachineHold hold, MotionProgram program, OriginRequest origin, FinishPlace finish, TimeProvider time, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(machine);
        ArgumentNullException.ThrowIfNull(hold);
        ArgumentNullException.ThrowIfNull(program);
        var place = await machine.LocateAsync(program.Profile.Axes, cancellation).ConfigureAwait(false);
        var found = WorkPlacement.Find(hold.Memory, place, origin, program.Profile, program.Start);
        if (found.Frame is not { } frame) return new JobPlacement(hold, place, found, program);
        if (found is { Source: OriginSource.Work, IsAssumed: true }) KeepOrThrow(hold, memory => memory.AssumeZero());
        if (found.Source == OriginSource.Work) await MarkAsync(machine, hold, place, time, cancellation).ConfigureAwait(false);
        return new JobPlacement(hold, place, found, program with { Finish = FinishOf(program, finish, frame) });
    }

    /// <summary>The machine is about to move: from now on nobody can say where it rests until it is heard again.</summary>
    /// <exception cref="MachineMemoryException">It cannot be written down.</exception>
    public void Begin() => KeepOrThrow(_hold, memory => memory with { IsMoving = true, Clock = _place.Clock ?? memory.Clock });

    /// <summary>The motion has ended.</summary>
    /// <returns>Null when it was written down.</returns>
    public Diagnostic? End(JobResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var rest = result.IsEndKnown ? result.FinalPosition : null;
        var failure = _hold.Keep(memory => memory with { IsMoving = rest is null, Rest = rest, Lost = result.PositionDoubt.Length > 0 ? result.PositionDoubt : memory.Lost });
        return failure is null ? null : PreparationRules.StateNotKept.At(default, failure);
    }

    /// <summary>Leaves the number in the controller by which the next session knows that it was not switched off.</summary>
    private static async Task MarkAsync(IMachineConnection machine, MachineHold hold, ControllerPlace place, TimeProvider time, CancellationToken cancellation)
    {
        if (!hold.IsKept || hold.Memory.IsSameZero(place)) return;
        var mark = (int)(time.GetUtcNow().ToUnixTimeMilliseconds() % 1_999_999_999) + 1;
        var isTaken = await machine.MarkAsync(mark, cancellation).ConfigureAwait(false);
        KeepOrThrow(hold, memory => memory with { Mark = isTaken ? mark : null, Clock = place.Clock });
    }

    /// <summary>Sets an origin at the present place, and vouches for the controller's zero from now on.</summary>
    /// <param name="set">From the machine's position, counts.</param>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    internal static async Task<MachineMemory> SetOriginAsync(IMachineConnection machine, MachineAxes axes, MachineHold hold, Func<MachineMemory, ControllerPlace, MachineMemory> set, TimeProvider time, CancellationToken cancellation)
    {
        var place = await machine.LocateAsync(axes, cancellation).ConfigureAwait(false);
        var knows = WorkPlacement.LossOf(hold.Memory, place) is null;
        KeepOrThrow(hold, memory => set(knows ? memory : memory.Forget(), place) with { Rest = place.Position, IsMoving = false });
        await MarkAsync(machine, hold, place, time, cancellation).ConfigureAwait(false);
        return hold.Memory;
    }

    private static CountsPoint? FinishOf(MotionProgram program, FinishPlace finish, CountsPoint frame) => finish switch
    {
        FinishPlace.Origin => program.Start,
        FinishPlace.Stay => null,
        FinishPlace.Park when program.Profile.Park is { } park && program.Profile.Scale.ToCounts(park) is var at => new CountsPoint(at.X - frame.X, at.Y - frame.Y),
        FinishPlace.Park => throw new ArgumentException("The machine profile has no park position.", nameof(finish)),
        _ => throw new ArgumentOutOfRangeException(nameof(finish), finish.ToString()),
    };

    private static void KeepOrThrow(MachineHold hold, Func<MachineMemory, MachineMemory> change)
    {
        if (hold.Keep(change) is { } failure) throw new MachineMemoryException(Wording.Get("Origins.NotWritten", failure));
    }
}

/// <summary>Where the machine goes behind the last stroke, tool off.</summary>
public enum FinishPlace
{
    /// <summary>The drawing's start point.</summary>
    Origin,

    /// <summary>It stays where the last stroke ended.</summary>
    Stay,

    /// <summary>The park position of the machine profile.</summary>
    Park,
}
