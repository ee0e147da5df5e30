using System.Text;

namespace Engraver.Core.Diagnostics;

/// <summary>All rules, and the page that documents them, written from the same table that the code uses.</summary>
public static class DiagnosticTable
{
    public static IReadOnlyList<DiagnosticRule> All { get; } = [.. DocumentRules.All, .. DxfRules.All, .. PreparationRules.All, .. SequencingRules.All, .. MotionRules.All, .. OffsetRules.All, .. KerfRules.All, .. PocketRules.All, .. VerificationRules.All, .. TrajectoryRules.All, .. SidecarRules.All, .. PostRules.All, .. SendingRules.All, .. FaultFileRules.All];

    /// <summary>The text of docs/diagnostics.md.</summary>
    /// <param name="fates">What becomes of each entity type, from DxfReader.TypeFates.</param>
    public static string ToMarkdown(IEnumerable<(string Fate, IEnumerable<string> Types)> fates)
    {
        ArgumentNullException.ThrowIfNull(fates);
        var page = new StringBuilder();
        page.Append("# Diagnostics\n\nWritten from the program's own table; `./test --update-golden` writes it anew. Ids are permanent. An *error* means that the file is unusable or truncated, or that a curve is lost (exit code 1). What stands in brackets is a setting by its key; the console shows its option, the desktop its command ([settings.md](settings.md)).\n\n");
        page.Append("| Id | Severity | What it says | What to do |\n|---|---|---|---|\n");
        foreach (var rule in All.OrderBy(rule => rule.Id, StringComparer.Ordinal))
        {
            page.Append('|').Append(' ').Append(rule.Id).Append(" | ").Append(SeverityWord(rule.Severity)).Append(" | ").Append(Cell(rule.Sentence)).Append(" | ").Append(Cell(rule.Advice)).Append(" |\n");
        }

        page.Append("\n## What becomes of each entity type\n\nA mesh among the polylines and every type that is not here is refused with its own line (DXF0016, DXF0012).\n\n");
        foreach (var (fate, types) in fates) page.Append("* ").Append(fate).Append(": ").AppendJoin(", ", types).Append('\n');
        return page.ToString();
    }

    /// <summary>The word for a severity in texts and JSON.</summary>
    public static string SeverityWord(Severity severity) => severity switch
    {
        Severity.Info => "info",
        Severity.Warning => "warning",
        Severity.Error => "error",
        _ => throw new ArgumentOutOfRangeException(nameof(severity)),
    };

    private static string Cell(string text) => text.Replace("|", "\\|", StringComparison.Ordinal);
}
