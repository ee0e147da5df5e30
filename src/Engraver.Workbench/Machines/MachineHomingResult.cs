using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Result of homing.</summary>
/// <param name="LostOrigins">Names of the origins that are lost because their zero was already unknown.</param>
public sealed record MachineHomingResult(JobResult Result, IReadOnlyList<string> LostOrigins);
