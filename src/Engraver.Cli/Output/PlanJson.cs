using System.Text.Json.Serialization;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver plan --json</c> prints; names, units and meanings are the runner's contract. Null: the machine cannot cut the drawing.</summary>
/// <param name="CutLength">Drawn length to be cut, mm.</param>
/// <param name="Travel">Between strokes, mm.</param>
/// <param name="PeakSpeed">While cutting, mm/s along the path.</param>
/// <param name="PeakAxisAcceleration">While cutting, mm/s2 of one axis.</param>
/// <param name="NotCut">Visible entities on the cut layers that produce no cut, by DXF type.</param>
/// <param name="Cost">From the given rates; null without rates.</param>
/// <param name="CostParts">Cost by item; null without rates.</param>
/// <param name="Uncut">Positions of the drawing that a tool of this diameter cannot reach, the largest first; empty without --kerf.</param>
/// <param name="Fonts">Of the texts that are cut; empty if none is.</param>
internal sealed record PlanJson(
    PlanJson.PlanSecondsJson? Seconds,
    double CutLength,
    double Travel,
    double? PeakSpeed,
    double? PeakAxisAcceleration,
    double? Cost,
    IReadOnlyDictionary<string, int> NotCut,
    PlanJson.PlanCostJson? CostParts,
    IReadOnlyList<PlanJson.PlanUncutJson> Uncut,
    IReadOnlyList<CutFont> Fonts)
{
    /// <summary>The plates that would be engraved, of which the other values describe the first; null for a drawing without plates.</summary>
    public IReadOnlyList<PlateReportJson>? Plates { get; init; }

    /// <summary>The operations; not written for a job without operations.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<OperationJson>? Operations { get; init; }

    /// <summary>The sections between which the tool is changed or the machine stops; not written for a job of one section.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<PlanSectionJson>? Sections { get; init; }

    /// <summary>The tools of the operations; not written for a job without operations, and where the machine cannot cut the drawing.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<PlanToolJson>? Tools { get; init; }

    /// <summary>What belongs to no operation; written where <see cref="Tools"/> is.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public PlanShareJson? Around { get; init; }

    /// <param name="Tool">Number of the tool.</param>
    /// <param name="Name">Of the tool; empty for none.</param>
    /// <param name="Operations">Ids.</param>
    /// <param name="Length">Of all strokes in plan, mm.</param>
    internal sealed record PlanToolJson(int Tool, string Name, IReadOnlyList<string> Operations, int Strokes, double Length, PlanShareJson Planned);

    /// <param name="Number">From 1.</param>
    /// <param name="Tool">Number of the tool.</param>
    /// <param name="Operations">Ids.</param>
    /// <param name="Seconds">Without the change of the tool; null when the machine cannot cut the drawing.</param>
    internal sealed record PlanSectionJson(int Number, int Tool, IReadOnlyList<string> Operations, int Strokes, double? Seconds)
    {
        /// <summary>The repeat of the first operation with which it begins after a stop, from 2; not written after a change of the tool.</summary>
        [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
        public int? Repeat { get; init; }

        /// <summary>The name of the tool and its number.</summary>
        [JsonIgnore]
        public string Title { get; init; } = "";
    }

    internal sealed record PlanSecondsJson(double Total, double Cutting, double Rapid, double Dwell)
    {
        public static PlanSecondsJson From(MotionTimes times) => new(times.Total, times.Cutting, times.Rapid, times.Dwell);
    }

    /// <param name="Distance">From the drawn line to the area that the tool reaches, mm.</param>
    /// <param name="Whole">The tool reaches no part of the contour.</param>
    internal sealed record PlanUncutJson(double X, double Y, double Distance, bool Whole);

    internal sealed record PlanCostJson(double Time, double Length, double Starts)
    {
        /// <returns>Null without a cost.</returns>
        public static PlanCostJson? From(JobCost? cost) => cost is null ? null : new(cost.Time, cost.Length, cost.Starts);
    }
}
