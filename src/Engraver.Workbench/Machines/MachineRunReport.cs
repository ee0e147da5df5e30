using Engraver.Galil.Jobs;

namespace Engraver.Workbench.Machines;

/// <summary>How a run ended and what it is worth.</summary>
/// <param name="Controller">The model as the controller names itself.</param>
/// <param name="PlannedSeconds">By the trapezoids the controller runs and the commands exchanged at standstills over this link (<see cref="JobTime"/>).</param>
public sealed record MachineRunReport(JobResult Result, RunJudgement Judgement, string Controller, double PlannedSeconds);
