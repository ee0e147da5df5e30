using Engraver.Core.Operations;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Gives the strokes of the operations their passes and depths. What is cut is then compared with these.</summary>
internal sealed class DressStage() : JobStage<OrderedJob, OrderedJob>("Dress", share: 0)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.Start, SettingTable.JoinTolerance, SettingTable.MaxError];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing has no operations.

    protected override OrderedJob Execute(OrderedJob job, CancellationToken cancellation)
    {
        if (job.Assignment is not { } assignment) return job;
        var passes = OperationPasses.Of(job.Operations, job.Drawn!, assignment.Contours, job.Drawing, StageOptions.SequencingFor(job.Drawing, job.Settings), job.Settings.MaxErrorMm);
        return job with { Sequence = passes.Sequence, Cut = new CutTable(passes.Sequence.Table, null, []), Passes = passes.Strokes, Places = passes.Places, Drawn = null, Findings = [.. job.Findings, .. passes.Findings] };
    }
}
