using System.Text.Json.Serialization;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver verify --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Target">The target as which the program was read.</param>
internal sealed record VerifyJson(double? MaxDeviation, double Tolerance, double MissingLength, double ExtraLength, bool Ok, double? MinFeed, double? MaxFeed, double? LowestZ, double? Blend, string Target)
{
    /// <summary>Largest distance of a cut from the drawing where it rounds a corner within the corner tolerance, mm; not part of
    /// <see cref="MaxDeviation"/>. Null where corners may not be rounded.</summary>
    public double? CornerDeviation { get; init; }

    /// <summary>What was measured of each operation; not written for a job without operations.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<MeasuredOperation>? Operations { get; init; }

    public static VerifyJson From(VerificationReport report, string target) =>
        new(report.MaxDeviationMm, report.ToleranceMm, report.MissingLengthMm, report.ExtraLengthMm, report.Ok, report.SlowestMmPerMinute, report.FastestMmPerMinute, report.LowestZMm, report.BlendMm, target) { CornerDeviation = report.CornerDeviationMm, Operations = report.Operations.Count == 0 ? null : report.Operations };
}
