using Engraver.Core.Diagnostics;
using Engraver.Core.Operations;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Compares the toolpath with the table of the entities to cut. With faults, those of texts included, there is no motion program.</summary>
internal sealed class CheckStage() : JobStage<MotionJob, CheckedJob>("Check", share: 5)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.MaxError, SettingTable.JoinTolerance, SettingTable.RecoverArcs];

    public override bool StartsStep => false;

    /// <summary>Faults of texts, positions where a toolpath, whose coordinates are finite, differs from the drawing, and strokes that are not as their
    /// operations state.</summary>
    public static IReadOnlyList<Diagnostic> FaultsOf(OrderedJob job, Toolpath toolpath) =>
        [.. TextFaultsOf(job), .. job.OperationFaults, .. ToolpathCheck.Findings(job.Cut.Table, toolpath, TolerancesOf(job), job.Drawing.SourceOf), .. OperationsFaultsOf(job, toolpath)];

    protected override CheckedJob Execute(MotionJob job, CancellationToken cancellation)
    {
        IReadOnlyList<Diagnostic> faults = job.Motion.Program is null ? [.. TextFaultsOf(job), .. job.OperationFaults] : FaultsOf(job, job.Toolpath);
        return new CheckedJob(faults.Count > 0 ? job with { Motion = job.Motion with { Program = null } } : job, faults);
    }

    private static IReadOnlyList<Diagnostic> OperationsFaultsOf(OrderedJob job, Toolpath toolpath) => job.Shapes.Count == 0
        ? []
        : [.. OperationCheck.Findings(job.Shapes, job.Assignment!.Contours, toolpath, job.Passes, TolerancesOf(job), job.Drawing.SourceOf), .. DashCheck.Findings(job.Shapes, job.Drawing, job.Settings.MaxErrorMm), .. LineWidthCheck.Findings(job.Assignment!, job.Drawing, toolpath, job.Passes)];

    private static ToolpathTolerances TolerancesOf(DrawnJob job) => new(job.Settings.MaxErrorMm, job.Settings.JoinToleranceMm, job.Settings.RecoverArcs);

    /// <summary>Fields without a value, and letters that are not at their places.</summary>
    public static IReadOnlyList<Diagnostic> TextFaultsOf(LetteredJob job) => [.. job.FieldFaults, .. job.Letters.Faults];

    protected override string SizeOf(CheckedJob job) => Wording.Get("Stage.Check.Figure", job.Faults.Count);
}
