using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs;

/// <summary>A move by hand instead of a cut: a rapid to one place of the controller's own counts, under the watchdog and the stop of a job. The tool is off throughout.</summary>
internal sealed class HandMove(JobMachine machine, CountsPoint goal) : IJobWay
{
    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public ValueTask<JobStep> CutAsync() => RapidMove.ToMachineAsync(machine, goal);

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
