namespace Engraver.Core.Machines.Moves;

/// <summary>How a homing ended.</summary>
/// <param name="Result">Complete when every axis has its zero.</param>
/// <param name="Shift">What was added to the counts of each axis, in the order of <see cref="MachineAxes.All"/>; 0 for one that is not homed. Null unless all of it was done.</param>
public sealed record HomingResult(JobResult Result, IReadOnlyList<int>? Shift);
