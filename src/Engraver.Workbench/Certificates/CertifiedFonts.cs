using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Certificates;

/// <summary>Compares the fonts of a job with those of the certificate beside its drawing: a program that was cut with other fonts cannot be judged by
/// letters of these.</summary>
public static class CertifiedFonts
{
    /// <summary>Adds the fonts that have changed since the certificate was issued (VER0024); the report is then not ok.</summary>
    /// <param name="target">Name of the post.</param>
    /// <param name="dialect">The kind of controller; null for the default.</param>
    public static VerificationReport Compare(VerificationReport report, Drawing drawing, DrawingSettings settings, string target, string? dialect)
    {
        ArgumentNullException.ThrowIfNull(report);
        ArgumentNullException.ThrowIfNull(drawing);
        if (!settings.Cut.HasFlag(CutChoice.Text) || drawing.Texts.Count == 0 || FileKind.IsStream(drawing.FileName)) return report;
        var path = CertificateFile.PathOf(drawing.FileName, target, IsDefault(target, dialect) ? null : dialect);
        if (CertificateFile.Read(path).Certificate is not { Fonts.Count: > 0 } certificate) return report;
        var changed = CutFont.Differences(certificate.Fonts, JobPreparation.To<LetteredJob>(drawing, settings).Letters.Fonts);
        if (changed.Count == 0) return report;
        return report with { Ok = false, Diagnostics = [VerificationRules.FontsChanged.At(default, string.Join(", ", changed), Path.GetFileName(path)), .. report.Diagnostics] };
    }

    private static bool IsDefault(string target, string? dialect) =>
        PostTable.All.FirstOrDefault(entry => entry.Post.Name == target)?.Post.Options.Any(option => option.Name == "dialect" && option.Default == dialect) == true;
}
