using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Arming;

/// <summary>An armed job, which may be started until a time or until a checked condition changes.</summary>
/// <param name="Job">Prepared in the style of the strategy.</param>
/// <param name="Until">Time at which arming expires.</param>
public sealed record ArmedJob(PreparedJob Job, ExecutionStrategy Strategy, bool DryRun, ArmingChecklist Checklist, DateTimeOffset Until);
