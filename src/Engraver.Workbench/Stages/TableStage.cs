using Engraver.Core.EntityTables;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Converts the curves of the selected layers to rows in millimetres and analyses the arcs.</summary>
internal sealed class TableStage() : JobStage<LetteredJob, AnalysedJob>("Table", share: 10)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.Layers, SettingTable.SkippedLayers];

    protected override AnalysedJob Execute(LetteredJob job, CancellationToken cancellation)
    {
        StageOptions.CheckLayers(job.Drawing, job.Settings);
        return new AnalysedJob(job, ArcAnalysis.Analyse(EntityTableBuilder.Build(job.Drawing, StageOptions.SelectionOf(job.Settings))));
    }

    protected override string SizeOf(AnalysedJob job) => Wording.Get("Stage.Table.Figure", job.Analysed.Count);
}
