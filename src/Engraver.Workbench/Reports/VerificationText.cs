using System.Globalization;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of a verification.</summary>
public static class VerificationText
{
    public static string Sentence(VerificationReport report) => report.CornerDeviationMm is { } corner && corner > report.MaxDeviationMm
        ? $"{Result(report)} {Wording.Get("VerificationText.Corners", corner)}"
        : Result(report);

    private static string Result(VerificationReport report) => Wording.Get("VerificationText.Result", report.Ok ? Wording.Get("VerificationText.Ok") : Wording.Get("VerificationText.NotOk"), report.MaxDeviationMm is { } deviation ? deviation.ToString("0.0000", CultureInfo.InvariantCulture) : "?", report.ToleranceMm, report.MissingLengthMm, report.ExtraLengthMm);
}
