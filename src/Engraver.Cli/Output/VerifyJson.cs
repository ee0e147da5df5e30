using Engraver.Workbench.Verification;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver verify --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Target">The target as which the program was read.</param>
internal sealed record VerifyJson(double? MaxDeviation, double Tolerance, double MissingLength, double ExtraLength, bool Ok, double? MinFeed, double? MaxFeed, double? LowestZ, double? Blend, string Target)
{
    public static VerifyJson From(VerificationReport report, string target) =>
        new(report.MaxDeviationMm, report.ToleranceMm, report.MissingLengthMm, report.ExtraLengthMm, report.Ok, report.SlowestMmPerMinute, report.FastestMmPerMinute, report.LowestZMm, report.BlendMm, target);
}
