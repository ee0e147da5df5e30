using System.Globalization;
using Engraver.Workbench.Verification;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver verify --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record VerifyJson(double? MaxDeviation, double Tolerance, double MissingLength, double ExtraLength, bool Ok)
{
    public static VerifyJson From(VerificationReport report) =>
        new(report.MaxDeviationMm, report.ToleranceMm, report.MissingLengthMm, report.ExtraLengthMm, report.Ok);

    /// <summary>The same for people.</summary>
    public string ToSentence() => string.Create(
        CultureInfo.InvariantCulture,
        $"{(Ok ? "ok" : "NOT OK")}: at worst {(MaxDeviation is { } deviation ? deviation.ToString("0.0000", CultureInfo.InvariantCulture) : "?")} mm beside the drawing ({Tolerance:0.0000} mm allowed), {MissingLength:0.###} mm missing, {ExtraLength:0.###} mm too much.");
}
