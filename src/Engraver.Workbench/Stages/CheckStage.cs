using Engraver.Core.Diagnostics;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Compares the toolpath with the table of the entities to cut. With faults there is no motion program.</summary>
internal sealed class CheckStage() : JobStage<MotionJob, CheckedJob>("Check", share: 5)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.MaxError, SettingTable.JoinTolerance, SettingTable.RecoverArcs];

    public override bool StartsStep => false;

    /// <summary>Positions where a toolpath, whose coordinates are finite, differs from the drawing.</summary>
    public static IReadOnlyList<Diagnostic> FaultsOf(CompensatedJob job, Toolpath toolpath) =>
        ToolpathCheck.Findings(job.Cut.Table, toolpath, new ToolpathTolerances(job.Settings.MaxErrorMm, job.Settings.JoinToleranceMm, job.Settings.RecoverArcs), job.Drawing.SourceOf);

    protected override CheckedJob Execute(MotionJob job, CancellationToken cancellation)
    {
        IReadOnlyList<Diagnostic> faults = job.Motion.Program is null ? job.Letters.Faults : [.. job.Letters.Faults, .. FaultsOf(job, job.Toolpath)];
        return new CheckedJob(faults.Count > 0 ? job with { Motion = job.Motion with { Program = null } } : job, faults);
    }

    protected override string SizeOf(CheckedJob job) => Wording.Get("Stage.Check.Figure", job.Faults.Count);
}
