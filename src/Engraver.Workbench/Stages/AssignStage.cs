using Engraver.Core.Diagnostics;
using Engraver.Core.Operations;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Divides the rows among the operations, if the settings have any.</summary>
internal sealed class AssignStage() : JobStage<AnalysedJob, AssignedJob>("Assign", share: 0)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.Layers, SettingTable.SkippedLayers, SettingTable.Operations, SettingTable.Tool, SettingTable.Machine, SettingTable.Feed, SettingTable.VectorSpeed];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing has no operations.

    protected override AssignedJob Execute(AnalysedJob job, CancellationToken cancellation)
    {
        if (job.Settings.Operations is not { } plan) return new AssignedJob(job, null);
        var assignment = OperationAssignment.Of(job.Analysed, job.Drawing, plan.PlacedOn(job.Drawing), job.Settings.Machine, MachineFamilies.DriverOf(job.Settings.Machine).Limits, job.Settings.Tool, StageOptions.SelectionOf(job.Settings), job.Source.Entities.Count + job.Source.Texts.Count);
        return new AssignedJob(job with { Drawing = assignment.Drawing, Findings = [.. job.Findings, .. assignment.Findings] }, assignment);
    }
}
