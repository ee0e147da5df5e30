using System.Globalization;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Reports;

/// <summary>How a verification is told to people.</summary>
public static class VerificationText
{
    public static string Sentence(VerificationReport report) => string.Create(
        CultureInfo.InvariantCulture,
        $"{(report.Ok ? "ok" : "NOT OK")}: at worst {(report.MaxDeviationMm is { } deviation ? deviation.ToString("0.0000", CultureInfo.InvariantCulture) : "?")} mm beside the drawing ({report.ToleranceMm:0.0000} mm allowed), {report.MissingLengthMm:0.###} mm missing, {report.ExtraLengthMm:0.###} mm too much.");
}
