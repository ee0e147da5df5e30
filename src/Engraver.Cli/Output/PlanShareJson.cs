using Engraver.Workbench.Reports;

namespace Engraver.Cli.Output;

/// <summary>Planned times and cost of a part of a job; names, units and meanings are the runner's contract.</summary>
/// <param name="Cost">Null without rates.</param>
/// <param name="CostParts">Cost by item; null without rates.</param>
internal sealed record PlanShareJson(PlanJson.PlanSecondsJson Seconds, double? Cost, PlanJson.PlanCostJson? CostParts)
{
    public static PlanShareJson From(JobShare share) => new(PlanJson.PlanSecondsJson.From(share.Times), share.Cost?.Total, PlanJson.PlanCostJson.From(share.Cost));
}
