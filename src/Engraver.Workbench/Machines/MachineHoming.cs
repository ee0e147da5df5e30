using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Homing of a connected machine, and its effect on the work origins.</summary>
/// <remarks>Before the first motion the position is recorded as unknown: if the host crashes during homing, some axes count from another zero. After homing the
/// controller gets a new mark, and origins set with the same homing are valid again, also after a power cycle.</remarks>
internal static class MachineHoming
{
    /// <param name="hold">The lease of the machine with its stored state.</param>
    /// <param name="start">Start position in the frame of the reported progress.</param>
    /// <param name="wall">Clock that provides the number of the mark in the controller.</param>
    /// <exception cref="ControllerException">The link could not be established, or the state of the machine cannot be written; nothing was moved.</exception>
    public static async Task<HomedMachine> RunAsync(
        MachineConnection connection, MachineHold hold, MachineProfile profile, CountsPoint start, string journal, IProgress<JobProgress> progress, TimeProvider wall, CancellationToken stop)
    {
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, stop).ConfigureAwait(false);
        var place = await machine.LocateAsync(profile.Axes, stop).ConfigureAwait(false);
        hold.Recognise(place);
        var before = hold.Memory;
        var knows = WorkPlacement.LossOf(before, place) is null;
        if (hold.Set(memory => memory with { Lost = Wording.Get("Homing.Unfinished"), IsMoving = true, Rest = null }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        var options = new JobOptions { JournalPath = journal, Address = connection.Description, DrawingName = "CNCHOME", DryRun = true };
        var (result, shift) = await machine.HomeAsync(new MotionProgram(profile, start, []), options, progress, stop).ConfigureAwait(false);
        if (shift is null)
        {
            if (result.FrameOrigin is null) hold.Keep(_ => before); // It was refused before any motion.
            else hold.KeepEnd(result);
            return new HomedMachine(result, []);
        }

        var after = before.Homed(profile, knows ? shift : null);
        await KeepAsync(machine, hold, profile, after, wall).ConfigureAwait(false);
        return new HomedMachine(result, [.. before.Origins.Where(origin => !origin.Value.IsAssumed && !after.Origins.ContainsKey(origin.Key)).Select(origin => origin.Key).Order(StringComparer.Ordinal)]);
    }

    /// <summary>Names of the origins that homing would invalidate: their zero is unknown.</summary>
    public static IReadOnlyList<string> WouldLose(MachineMemory memory, bool knowsZero, MachineProfile profile) => knowsZero && memory.Lost.Length == 0
        ? []
        : memory.HomedAs == profile.HomedAs ? [] : [.. memory.Origins.Where(origin => !origin.Value.IsAssumed).Select(origin => origin.Key).Order(StringComparer.Ordinal)];

    /// <summary>Not cancellable: homing is complete and its result must be stored.</summary>
    private static async Task KeepAsync(IMachineConnection machine, MachineHold hold, MachineProfile profile, MachineMemory after, TimeProvider wall)
    {
        var mark = MachineMemory.NewMark(wall.GetUtcNow());
        if (!await machine.MarkAsync(mark, CancellationToken.None).ConfigureAwait(false)) throw new MachineMemoryException(Wording.Get("Origins.NoRoomForMark"));
        var place = await machine.LocateAsync(profile.Axes, CancellationToken.None).ConfigureAwait(false);
        if (hold.Set(_ => after with { Mark = mark, Clock = place.Clock, Rest = place.Position, IsMoving = false }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        hold.Recognise(place with { Mark = mark, StoppedHard = "" }); // That was before homing.
    }
}

/// <summary>Result of homing.</summary>
/// <param name="Forgotten">Names of the origins that are lost because their zero was already unknown.</param>
public sealed record HomedMachine(JobResult Result, IReadOnlyList<string> Forgotten);
