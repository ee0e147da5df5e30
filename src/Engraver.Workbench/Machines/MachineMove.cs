using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>One move by hand on a machine that stays connected.</summary>
internal static class MachineMove
{
    /// <param name="hold">The machine in this host's hands.</param>
    /// <param name="start">Where the machine stands, in the frame in which progress is told.</param>
    /// <param name="goal">Controller counts.</param>
    /// <param name="journal">Where what was found in the controller is written down, for whoever comes after a crash.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link never came up.</exception>
    public static async Task<JobResult> ToAsync(
        MachineConnection connection, MachineHold hold, MachineProfile profile, CountsPoint start, CountsPoint goal, string journal, IProgress<JobProgress> progress, CancellationToken stop)
    {
        var options = new JobOptions { JournalPath = journal, Address = connection.Description, DrawingName = "CNCGOTO", DryRun = true };
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, stop).ConfigureAwait(false);
        if (hold.Keep(memory => memory with { IsMoving = true }) is { } failure) throw new MachineMemoryException(Wording.Get("Origins.NotWritten", failure));
        var result = await machine.GoToAsync(new MotionProgram(profile, start, []), goal, options, progress, stop).ConfigureAwait(false);
        var rest = result.IsEndKnown ? result.FinalPosition : null;
        hold.Keep(memory => memory with { IsMoving = rest is null, Rest = rest, Lost = result.PositionDoubt.Length > 0 ? result.PositionDoubt : memory.Lost });
        return result;
    }
}
