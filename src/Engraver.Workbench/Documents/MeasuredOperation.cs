using System.Text.Json.Serialization;
using Engraver.Core.Operations;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Documents;

/// <summary>What was measured of one operation, each of its passes by its own nominal path; millimetres.</summary>
/// <param name="Id">Its id in the operations of the job.</param>
/// <param name="Name">Its name; empty for none.</param>
/// <param name="Kind">As files write it.</param>
/// <param name="Tool">Number of its tool.</param>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the path of its pass.</param>
/// <param name="MissingLength">Length of the path of its passes that was not cut; of the passes of which something was cut.</param>
/// <param name="ExtraLength">Length that was cut beside the path of its passes.</param>
/// <param name="Feed">The fastest cutting speed over a tenth of a second, mm/min; null where it is unknown.</param>
/// <param name="Depths">Deepest place of each pass below the top of the work; null for a pass of which nothing was cut. Empty without heights.</param>
public sealed record MeasuredOperation(string Id, string Name, string Kind, int Tool, double MaxDeviation, double MissingLength, double ExtraLength, double? Feed, IReadOnlyList<double?> Depths)
{
    /// <summary>The name, or the id where it has none.</summary>
    [JsonIgnore]
    public string Title => Name.Length > 0 ? Name : Id;

    /// <summary>Largest distance from the path of its pass where a corner was rounded within the corner tolerance; null if corners may not be
    /// rounded.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public double? CornerDeviation { get; init; }

    /// <summary>Number of cutting samples with outputs other than those of the operation; null for none.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public long? OutputFaults { get; init; }

    /// <summary>The operation in two runs, each of which cut some of its passes.</summary>
    /// <param name="later">The run that cut the later ones.</param>
    internal MeasuredOperation With(MeasuredOperation later) => this with
    {
        MaxDeviation = Math.Max(MaxDeviation, later.MaxDeviation),
        CornerDeviation = CornerDeviation > later.CornerDeviation || later.CornerDeviation is null ? CornerDeviation : later.CornerDeviation,
        MissingLength = MissingLength + later.MissingLength,
        ExtraLength = ExtraLength + later.ExtraLength,
        Feed = Feed > later.Feed || later.Feed is null ? Feed : later.Feed,
        OutputFaults = OutputFaults is null && later.OutputFaults is null ? null : (OutputFaults ?? 0) + (later.OutputFaults ?? 0),
        Depths = [.. Depths, .. later.Depths],
    };

    /// <param name="passes">In order; null for one of which nothing was cut.</param>
    /// <param name="hasHeights">The heights of the tool were measured.</param>
    /// <returns>Null where no pass of the operation was cut.</returns>
    internal static MeasuredOperation? Of(Operation operation, IReadOnlyList<MeasuredPass?> passes, bool hasHeights)
    {
        var cut = passes.OfType<MeasuredPass>().ToList();
        return cut.Count == 0 ? null : new MeasuredOperation(
            operation.Id, operation.Name, operation.KindWord, operation.Tool, cut.Max(pass => pass.MaxDeviation), cut.Sum(pass => pass.MissingLength), cut.Sum(pass => pass.ExtraLength),
            cut.Max(pass => pass.FeedMmPerMinute), hasHeights ? [.. passes.Select(pass => pass?.Depth)] : []) { OutputFaults = cut.Sum(pass => pass.OutputFaults) is > 0 and var faults ? faults : null, CornerDeviation = cut.Max(pass => pass.CornerDeviation) };
    }
}
