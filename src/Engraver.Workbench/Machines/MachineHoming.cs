using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Homing of a connected machine, and its effect on the work origins.</summary>
/// <remarks>Before the first motion the position is recorded as unknown: if the host crashes during homing, some axes count from another zero. After homing the
/// controller gets a new mark, and origins set with the same homing are valid again, also after a power cycle.</remarks>
internal static class MachineHoming
{
    /// <param name="lease">The lease of the machine with its stored state.</param>
    /// <param name="start">Start position in the frame of the reported progress.</param>
    /// <param name="wall">Clock that provides the number of the mark in the controller.</param>
    /// <exception cref="ControllerException">The link could not be established, or the state of the machine cannot be written; nothing was moved.</exception>
    public static async Task<MachineHomingResult> RunAsync(
        MachineConnection connection, MachineLease lease, MachineProfile profile, CountsPoint start, string journal, IProgress<JobProgress> progress, TimeProvider wall, CancellationToken stop)
    {
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, stop).ConfigureAwait(false);
        var place = await machine.ReadPositionAsync(profile.Axes, stop).ConfigureAwait(false);
        lease.CompareZero(place);
        var before = lease.Memory;
        var knows = WorkPlacement.ZeroDoubt(before, place) is null;
        if (lease.Commit(memory => memory with { Lost = Wording.Get("Homing.Unfinished"), IsMoving = true, RestPosition = null }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        var options = new JobOptions { JournalPath = journal, Address = connection.Description, DrawingName = "CNCHOME", DryRun = true };
        var (result, shift) = await machine.HomeAsync(new MotionProgram(profile, start, []), options, progress, stop).ConfigureAwait(false);
        if (shift is null)
        {
            if (result.FrameOrigin is null) lease.Update(_ => before); // It was refused before any motion.
            else lease.NoteMotionEnd(result);
            return new MachineHomingResult(result, []);
        }

        var after = before.Homed(profile, knows ? shift : null);
        await SaveAsync(machine, lease, profile, after, wall).ConfigureAwait(false);
        return new MachineHomingResult(result, [.. before.Origins.Where(origin => !origin.Value.IsAssumed && !after.Origins.ContainsKey(origin.Key)).Select(origin => origin.Key).Order(StringComparer.Ordinal)]);
    }

    /// <summary>Names of the origins that homing would invalidate: their zero is unknown.</summary>
    public static IReadOnlyList<string> OriginsLost(StoredMachineState memory, bool knowsZero, MachineProfile profile) => knowsZero && memory.Lost.Length == 0
        ? []
        : memory.HomedAs == profile.HomedAs ? [] : [.. memory.Origins.Where(origin => !origin.Value.IsAssumed).Select(origin => origin.Key).Order(StringComparer.Ordinal)];

    /// <summary>Not cancellable: homing is complete and its result must be stored.</summary>
    private static async Task SaveAsync(IMachineConnection machine, MachineLease lease, MachineProfile profile, StoredMachineState after, TimeProvider wall)
    {
        var mark = StoredMachineState.NewMark(wall.GetUtcNow());
        if (!await machine.StoreMarkAsync(mark, CancellationToken.None).ConfigureAwait(false)) throw new MachineMemoryException(Wording.Get("Origins.NoRoomForMark"));
        var place = await machine.ReadPositionAsync(profile.Axes, CancellationToken.None).ConfigureAwait(false);
        if (lease.Commit(_ => after with { Mark = mark, Clock = place.Clock, RestPosition = place.Position, IsMoving = false }) is { } failure) throw MachineMemoryException.NotWritten(failure);
        lease.CompareZero(place with { Mark = mark, StoppedWithoutRamp = "" }); // That was before homing.
    }
}
