using Engraver.Galil.Jobs;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines;

/// <summary>A job that was checked and may be started until a moment, or until anything it was checked against changes.</summary>
/// <param name="Job">Prepared in the style of the mode.</param>
/// <param name="Until">When arming ends by itself.</param>
public sealed record ArmedJob(PreparedJob Job, JobMode Mode, bool DryRun, ArmingChecklist Checklist, DateTimeOffset Until);
