using Engraver.Galil.Jobs;

namespace Engraver.Workbench.Machines;

/// <summary>How a run ended and what it is worth.</summary>
/// <param name="Controller">The model as the controller names itself.</param>
/// <param name="PlannedSeconds">By the trapezoids the controller runs and the commands exchanged at standstills over this link (<see cref="JobTime"/>).</param>
public sealed record MachineRunReport(JobResult Result, RunJudgement Judgement, string Controller, double PlannedSeconds)
{
    /// <summary>Why the trace of the wire ended before the job did; null when it is whole, or none was wanted.</summary>
    public string? TraceFailure { get; init; }
}
