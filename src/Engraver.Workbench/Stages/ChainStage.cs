using Engraver.Core.Sequencing;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Removes duplicates, recovers arcs if requested, joins entities to contours and determines their nesting.</summary>
internal sealed class ChainStage() : JobStage<ShapedJob, ChainedJob>("Chain", share: 27)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.KeepDuplicates, SettingTable.RecoverArcs, SettingTable.Machine];

    protected override ChainedJob Execute(ShapedJob job, CancellationToken cancellation) => new(job, Sequencer.Chain(job.Cut.Table, job.Drawing, StageOptions.SequencingFor(job)));

    protected override string SizeOf(ChainedJob job) => Wording.Get("Stage.Chain.Figure", job.Chained.Chain.Contours.Count);
}
