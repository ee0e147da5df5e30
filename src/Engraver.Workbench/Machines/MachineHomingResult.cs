using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>Result of homing.</summary>
/// <param name="LostOrigins">Names of the origins that are lost because their zero was already unknown.</param>
public sealed record MachineHomingResult(JobResult Result, IReadOnlyList<string> LostOrigins);
