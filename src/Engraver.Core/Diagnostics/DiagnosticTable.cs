using System.Text;

namespace Engraver.Core.Diagnostics;

/// <summary>All rules, and the page that documents them, written from the same table that the code uses.</summary>
public static class DiagnosticTable
{
    public static IReadOnlyList<DiagnosticRule> All { get; } = [.. DocumentRules.All, .. DxfRules.All, .. PreparationRules.All, .. SequencingRules.All, .. MotionRules.All, .. OffsetRules.All, .. KerfRules.All, .. PocketRules.All, .. LetteringRules.All, .. VerificationRules.All, .. TrajectoryRules.All, .. SidecarRules.All, .. PostRules.All, .. SendingRules.All, .. SerialRules.All, .. OperationRules.All, .. PlacementRules.All, .. FaultFileRules.All];

    /// <summary>The text of docs/diagnostics.md.</summary>
    /// <param name="fates">How each entity type is read, from DxfReader.TypeFates.</param>
    public static string ToMarkdown(IEnumerable<(string Fate, IEnumerable<string> Types)> fates)
    {
        ArgumentNullException.ThrowIfNull(fates);
        var page = new StringBuilder();
        page.Append("# Diagnostics\n\n").Append(Wrapped("This page is generated from the program's own table (`./test --update-golden`). Ids are permanent. An *error* means that the file is unusable or truncated, or that a curve is lost (exit code 1). Words in brackets are keys of settings: the console shows the option, the desktop the command ([settings.md](settings.md)).")).Append('\n');
        page.Append("| Id | Severity | Message | What to do |\n|---|---|---|---|\n");
        foreach (var rule in All.OrderBy(rule => rule.Id, StringComparer.Ordinal))
        {
            page.Append('|').Append(' ').Append(rule.Id).Append(" | ").Append(SeverityWord(rule.Severity)).Append(" | ").Append(Cell(rule.Sentence)).Append(" | ").Append(Cell(rule.Advice)).Append(" |\n");
        }

        page.Append("\n## How each entity type is read\n\n").Append(Wrapped("A mesh among the polylines and every type that is not in this list are left out and reported (DXF0016, DXF0012).")).Append('\n');
        foreach (var (fate, types) in fates) page.Append(Wrapped($"* {fate}: {string.Join(", ", types)}", "  "));
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

    /// <summary>The words in lines that are short enough to read as source.</summary>
    private static string Wrapped(string words, string indent = "")
    {
        const int longest = 150;
        var (text, line) = (new StringBuilder(), 0);
        foreach (var word in words.Split(' '))
        {
            var isNew = line > 0 && line + 1 + word.Length > longest;
            text.Append(isNew ? $"\n{indent}" : line > 0 ? " " : "").Append(word);
            line = (isNew ? indent.Length : line > 0 ? line + 1 : 0) + word.Length;
        }

        return text.Append('\n').ToString();
    }

    private static string Cell(string text) => text.Replace("|", "\\|", StringComparison.Ordinal);
}
