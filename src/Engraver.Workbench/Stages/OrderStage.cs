using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Orders, reverses and rotates the contours.</summary>
internal sealed class OrderStage() : JobStage<ChainedJob, OrderedJob>("Order", share: 13)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.Order, SettingTable.Enter, SettingTable.Start, SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.KeepDuplicates, SettingTable.RecoverArcs, SettingTable.Machine];

    public override bool StartsStep => false;

    protected override OrderedJob Execute(ChainedJob job, CancellationToken cancellation)
    {
        var ordered = new OrderedJob(job, Sequencer.Order(job.Chained, StageOptions.SequencingFor(job)));
        if (job.Assignment is null) return ordered;
        var options = StageOptions.SequencingFor(job.Drawing, job.Settings) with { CutsHeights = false, Entry = null };
        return ordered with { Operations = OperationOrder.Of(job.Shapes, job.Drawing, options), Drawn = job.Chained };
    }

    protected override string SizeOf(OrderedJob job) => Wording.Get("Stage.Order.Figure", job.Sequence.Travel / 1000);
}
