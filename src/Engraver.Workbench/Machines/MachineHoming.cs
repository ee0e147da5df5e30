using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Homing of a machine that stays connected, and what it means for its work origins.</summary>
/// <remarks>Before the first motion it is written down that nobody knows the machine's position: a host that dies in the middle leaves a controller of
/// which some axes count from another zero. When every axis has
/// its zero the controller is marked anew, and origins that were set by the same homing are where they were, also after a power cycle.</remarks>
internal static class MachineHoming
{
    /// <param name="hold">The reservation of the machine by this host, with what is kept of it.</param>
    /// <param name="start">Where the machine stands, in the frame in which progress is told.</param>
    /// <param name="wall">Where the mark that is left in the controller takes its number from.</param>
    /// <exception cref="ControllerException">The link never came up, or what is known of the machine cannot be written down; nothing was moved
    /// then.</exception>
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
            if (result.FrameOrigin is null) hold.Keep(_ => before); // it was refused before anything moved
            else hold.KeepEnd(result);
            return new HomedMachine(result, []);
        }

        var after = before.Homed(profile, knows ? shift : null);
        await KeepAsync(machine, hold, profile, after, wall).ConfigureAwait(false);
        return new HomedMachine(result, [.. before.Origins.Where(origin => !origin.Value.IsAssumed && !after.Origins.ContainsKey(origin.Key)).Select(origin => origin.Key).Order(StringComparer.Ordinal)]);
    }

    /// <summary>The names of the origins that a homing of this machine would lose: they were set by a zero that is not known any more.</summary>
    public static IReadOnlyList<string> WouldLose(MachineMemory memory, bool knowsZero, MachineProfile profile) => knowsZero && memory.Lost.Length == 0
        ? []
        : memory.HomedAs == profile.HomedAs ? [] : [.. memory.Origins.Where(origin => !origin.Value.IsAssumed).Select(origin => origin.Key).Order(StringComparer.Ordinal)];

    /// <summary>The homing is done whatever the operator wants meanwhile: what is known of it is kept.</summary>
    private static async Task KeepAsync(IMachineConnection machine, MachineHold hold, MachineProfile profile, MachineMemory after, TimeProvider wall)
    {
        var mark = MachineMemory.NewMark(wall.GetUtcNow());
        if (!await machine.MarkAsync(mark, CancellationToken.None).ConfigureAwait(false)) throw new MachineMemoryException(Wording.Get("Origins.NoRoomForMark"));
        var place = await machine.LocateAsync(profile.Axes, CancellationToken.None).ConfigureAwait(false);
        if (hold.Set(_ => after with { Mark = mark, Clock = place.Clock, Rest = place.Position, IsMoving = false }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        hold.Recognise(place with { Mark = mark, StoppedHard = "" }); // that was before the homing
    }
}

/// <summary>How a homing ended.</summary>
/// <param name="Forgotten">Names of the origins that nobody can find any more, because they were set by a zero that was lost before.</param>
public sealed record HomedMachine(JobResult Result, IReadOnlyList<string> Forgotten);
