using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering.Optimising;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Orders, reverses and rotates the contours.</summary>
/// <param name="time">Limits a search in seconds.</param>
internal sealed class OrderStage(TimeProvider time) : JobStage<ChainedJob, OrderedJob>("Order", share: 13)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.Order, SettingTable.OrderCost, SettingTable.OrderSeconds, SettingTable.Enter, SettingTable.Start, SettingTable.Finish, SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.KeepDuplicates, SettingTable.RecoverArcs, SettingTable.Machine, SettingTable.Rapid, SettingTable.Acceleration];

    public override bool StartsStep => false;

    protected override OrderedJob Execute(ChainedJob job, CancellationToken cancellation)
    {
        using var searches = new OrderSearches(job.Settings, Math.Max(1, job.Assignment is null ? 1 : job.Shapes.Count), time, cancellation, job.OrderStop);
        if (job.Assignment is null) return new OrderedJob(job, Sequencer.Order(job.Chained, StageOptions.SequencingFor(job) with { Search = searches.Next() }));
        var options = StageOptions.SequencingFor(job.Drawing, job.Settings) with { CutsHeights = false, Entry = null };
        var drawn = Sequencer.Order(job.Chained, StageOptions.SequencingFor(job) with { Search = new OrderSearch { Steps = 0 } }); // the operations are cut in their own order
        return new OrderedJob(job, drawn) with { Operations = OperationOrder.Of(job.Shapes, job.Drawing, options, searches.Next), Drawn = job.Chained };
    }

    protected override string SizeOf(OrderedJob job) => Wording.Get("Stage.Order.Figure", job.Sequence.Travel / 1000);
}
