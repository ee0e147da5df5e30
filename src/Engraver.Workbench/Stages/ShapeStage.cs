using Engraver.Core.Operations;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Makes the path of the tool's centre of each operation, if the settings have any.</summary>
internal sealed class ShapeStage() : JobStage<CompensatedJob, ShapedJob>("Shape", share: 0)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.KeepDuplicates, SettingTable.RecoverArcs];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing has no operations.

    protected override ShapedJob Execute(CompensatedJob job, CancellationToken cancellation)
    {
        if (job.Assignment is not { Faults.Count: 0 } assignment) return new ShapedJob(job, []);
        var shaper = new OperationShaper(job.Drawing, StageOptions.SequencingFor(job.Drawing, job.Settings) with { CutsHeights = false }, job.Settings.MaxErrorMm);
        var shapes = new List<ShapedOperation>();
        foreach (var part in assignment.Parts)
        {
            cancellation.ThrowIfCancellationRequested();
            shapes.Add(shaper.Shape(part));
        }

        return new ShapedJob(job with { Findings = [.. job.Findings, .. shapes.SelectMany(shape => shape.Findings)] }, shapes);
    }
}
