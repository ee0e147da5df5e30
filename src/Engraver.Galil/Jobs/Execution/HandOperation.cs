using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Motion by hand that is run as a job without strokes: under its watchdog, its stop and its promise to leave the controller as it was
/// found.</summary>
/// <param name="Resident">The program in the controller meanwhile; null for that of a stream.</param>
/// <param name="Create">What is done with the machine.</param>
internal sealed record HandOperation(ResidentProgram? Resident, Func<JobMachine, IJobStrategy> Create)
{
    /// <summary>The tool is off throughout; false where switching it is all that is done.</summary>
    public bool IsDry { get; init; } = true;
}

/// <summary>The tool's output on for the profile's settle time and off again, while nothing moves.</summary>
internal sealed class OutputPulse(JobMachine machine) : IJobStrategy
{
    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public async ValueTask<JobStep> CutAsync() => await machine.Tool.OnAsync(machine.Here).ConfigureAwait(false) is { Ends: true } end ? end : await machine.Tool.OffAsync().ConfigureAwait(false);

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}

/// <summary>A move without cutting: a rapid to one point in the controller's own counts, under the watchdog and the stop of a job. The tool is off
/// throughout.</summary>
/// <param name="withHeight">The height is part of the place; otherwise it stays as it is.</param>
/// <param name="speed">SP of each axis; null for rapid speed.</param>
internal sealed class HandMove(JobMachine machine, CountsPoint goal, bool withHeight, Func<MachineAxis, int>? speed = null) : IJobStrategy
{
    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    /// <summary>Up before the way and down behind it.</summary>
    public async ValueTask<JobStep> CutAsync()
    {
        var isUp = withHeight && machine.Profile.Up * ((long)goal.Z - machine.State.Position.Z) > 0;
        if (isUp && await ToHeightAsync().ConfigureAwait(false) is { Ends: true } low) return low;
        if (await RapidMove.ToMachineAsync(machine, goal, speed).ConfigureAwait(false) is { Ends: true } end) return end;
        return withHeight && !isUp ? await ToHeightAsync().ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>Not while a job that is on its way back stands held.</summary>
    private async ValueTask<JobStep> ToHeightAsync() =>
        await machine.Hold.GateAsync().ConfigureAwait(false) is { Ends: true } held ? held : await RapidMove.ToHeightAsync(machine, goal.Z, speed).ConfigureAwait(false);

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
