using Engraver.Core.Diagnostics;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Compares the toolpath with the table of the entities to cut. With faults, those of texts included, there is no motion program.</summary>
internal sealed class CheckStage() : JobStage<MotionJob, CheckedJob>("Check", share: 5)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.MaxError, SettingTable.JoinTolerance, SettingTable.RecoverArcs];

    public override bool StartsStep => false;

    /// <summary>Faults of texts, and positions where a toolpath, whose coordinates are finite, differs from the drawing.</summary>
    public static IReadOnlyList<Diagnostic> FaultsOf(CompensatedJob job, Toolpath toolpath) =>
        [.. TextFaultsOf(job), .. ToolpathCheck.Findings(job.Cut.Table, toolpath, new ToolpathTolerances(job.Settings.MaxErrorMm, job.Settings.JoinToleranceMm, job.Settings.RecoverArcs), job.Drawing.SourceOf)];

    protected override CheckedJob Execute(MotionJob job, CancellationToken cancellation)
    {
        var faults = job.Motion.Program is null ? TextFaultsOf(job) : FaultsOf(job, job.Toolpath);
        return new CheckedJob(faults.Count > 0 ? job with { Motion = job.Motion with { Program = null } } : job, faults);
    }

    /// <summary>Fields without a value, and letters that are not at their places.</summary>
    public static IReadOnlyList<Diagnostic> TextFaultsOf(LetteredJob job) => [.. job.FieldFaults, .. job.Letters.Faults];

    protected override string SizeOf(CheckedJob job) => Wording.Get("Stage.Check.Figure", job.Faults.Count);
}
