namespace Engraver.Cli.Output;

/// <summary>What <c>engraver plan --json</c> prints; names, units and meanings are the runner's contract. Null: the machine cannot cut what is drawn.</summary>
/// <param name="CutLength">Drawn length to be cut, mm.</param>
/// <param name="Travel">Between strokes, mm.</param>
/// <param name="PeakSpeed">While cutting, mm/s along the path.</param>
/// <param name="PeakAxisAcceleration">While cutting, mm/s2 of one axis.</param>
/// <param name="NotCut">What is seen on the layers that are cut and gives no cut, by DXF type.</param>
/// <param name="Cost">By the rates that were given; null without any.</param>
/// <param name="CostParts">What it is for; null as the cost.</param>
/// <param name="Uncut">Places of the drawing that a tool of this diameter does not reach, the largest first; empty without --kerf.</param>
internal sealed record PlanJson(
    PlanJson.PlanSecondsJson? Seconds,
    double CutLength,
    double Travel,
    double? PeakSpeed,
    double? PeakAxisAcceleration,
    double? Cost,
    IReadOnlyDictionary<string, int> NotCut,
    PlanJson.PlanCostJson? CostParts,
    IReadOnlyList<PlanJson.PlanUncutJson> Uncut)
{
    internal sealed record PlanSecondsJson(double Total, double Cutting, double Rapid, double Dwell);

    /// <param name="Distance">Of the drawn line from what the tool reaches, mm.</param>
    /// <param name="Whole">Nothing of the contour is reached.</param>
    internal sealed record PlanUncutJson(double X, double Y, double Distance, bool Whole);

    internal sealed record PlanCostJson(double Time, double Length, double Starts);
}
