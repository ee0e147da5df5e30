using System.Text.Json.Serialization;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>One operation of a job, in <c>plan</c>, <c>run</c> and <c>sequence</c>; names, units and meanings are the runner's contract.</summary>
/// <param name="Feed">mm/min.</param>
/// <param name="Plunge">mm/min; null on a machine without a tool axis.</param>
/// <param name="Depth">mm; null on a machine without a tool axis.</param>
/// <param name="Curves">Entities that it takes.</param>
/// <param name="Strokes">Every pass is one.</param>
/// <param name="Passes">Passes of each stroke.</param>
/// <param name="Length">Of all strokes in plan, mm.</param>
/// <param name="Uncut">Places that its tool does not reach.</param>
internal sealed record OperationJson(string Id, string Name, string Kind, int Tool, double Feed, double? Plunge, double? Depth, int Curves, int Strokes, int Passes, double Length, int Uncut)
{
    /// <summary>Power of a beam, percent; not written where none is stated.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public double? Power { get; init; }

    /// <summary>What was measured; not written where nothing was.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public MeasuredJson? Measured { get; init; }

    /// <summary>Planned times and cost; written by <c>plan</c> only, and not where the machine cannot cut the drawing.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public PlanShareJson? Planned { get; init; }

    /// <summary>The operations of a job; null for a job without operations.</summary>
    /// <param name="measured">What was measured of them; empty for a plan.</param>
    public static IReadOnlyList<OperationJson>? Of(PreparedJob? job, IReadOnlyList<MeasuredOperation> measured) => job?.Settings.Operations is null
        ? null
        : [.. OperationSummary.Of(job).Select(one => new OperationJson(one.Operation.Id, one.Operation.Name, one.Operation.KindWord, one.Tool.Number, one.Feed, one.Plunge, one.Operation.Depth, one.Curves, one.Strokes, one.Passes, one.Length, one.Uncut)
        {
            Power = one.Operation.Power,
            Measured = measured.FirstOrDefault(found => found.Id == one.Operation.Id) is { } found ? new MeasuredJson(found.MaxDeviation, found.MissingLength, found.ExtraLength, found.Feed, found.Depths) { CornerDeviation = found.CornerDeviation } : null,
        })];

    /// <param name="Feed">The fastest cutting speed, mm/min; null when unknown.</param>
    /// <param name="Depths">Of each pass, mm; empty without a tool axis.</param>
    internal sealed record MeasuredJson(double MaxDeviation, double MissingLength, double ExtraLength, double? Feed, IReadOnlyList<double?> Depths)
    {
        /// <summary>Where corners were rounded, mm; not written without a corner tolerance.</summary>
        [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
        public double? CornerDeviation { get; init; }
    }
}
