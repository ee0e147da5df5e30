namespace Engraver.Core.Machines.Moves;

/// <summary>How a homing ended.</summary>
/// <param name="Result">Complete when every axis has its zero.</param>
/// <param name="Shift">The counts that were added to each axis, in the order of <see cref="MachineAxes.All"/>; 0 for an axis that is not homed. Null unless all
/// axes were homed.</param>
public sealed record HomingResult(JobResult Result, IReadOnlyList<int>? Shift);
