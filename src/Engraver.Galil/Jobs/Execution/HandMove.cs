using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>A move without cutting: a rapid to one point in the controller's own counts, with the watchdog and the stop of a job. The tool is off
/// throughout.</summary>
/// <param name="withHeight">The height is part of the goal; otherwise it does not change.</param>
/// <param name="speed">SP of each axis; null for rapid speed.</param>
internal sealed class HandMove(JobMachine machine, CountsPoint goal, bool withHeight, Func<MachineAxis, int>? speed = null) : IJobStrategy
{
    public Phase Whole => Phase.Idle;

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    /// <summary>Up before the move in X and Y, and down after it.</summary>
    public async ValueTask CutAsync()
    {
        var isUp = withHeight && machine.Profile.UpSign * ((long)goal.Z - machine.State.Position.Z) > 0;
        if (isUp) await ToHeightAsync().ConfigureAwait(false);
        await RapidMove.ToMachineAsync(machine, goal, speed).ConfigureAwait(false);
        if (withHeight && !isUp) await ToHeightAsync().ConfigureAwait(false);
    }

    /// <summary>Waits while a job that returns to its path is held.</summary>
    private async ValueTask ToHeightAsync()
    {
        await machine.Hold.GateAsync().ConfigureAwait(false);
        await RapidMove.ToHeightAsync(machine, goal.Z, speed).ConfigureAwait(false);
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
