using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Records;

/// <summary>Collects findings: the first hundred of each rule; the rest are counted and summarized in one line.</summary>
internal sealed class ImportLog(string placeWord)
{
    private const int ShownPerRule = 100;
    private readonly List<Diagnostic> _diagnostics = [];
    private readonly Dictionary<DiagnosticRule, int> _counts = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<DiagnosticRule, string> _reasons = new(ReferenceEqualityComparer.Instance);

    public void Add(DiagnosticRule rule, int line, params ReadOnlySpan<string> facts)
    {
        if (Counted(rule)) _diagnostics.Add(rule.At(new SourceRef(line), facts));
    }

    /// <summary>Adds a finding about a record. Ignored widths and dashes are reported once, however many curves have them.</summary>
    public void Add(in RecordIssue issue)
    {
        if ((issue.Rule == DxfRules.WidthIgnored || issue.Rule == DxfRules.Dashed) && _counts.ContainsKey(issue.Rule)) return;
        if (!Counted(issue.Rule)) return;
        var source = new SourceRef(issue.Line, HandleText(issue.Handle));
        _diagnostics.Add(issue.Rule.At(source, issue.Type, Place(issue.Line), issue.Detail));
    }

    /// <summary>The row of the balance for a refused record. Refusals for the same reason share its text.</summary>
    public RefusedEntity Refusal(in RecordIssue issue)
    {
        if (issue.Detail.Length > 0 || !_reasons.TryGetValue(issue.Rule, out var reason))
        {
            reason = Reason(issue);
            if (issue.Detail.Length == 0) _reasons.Add(issue.Rule, reason);
        }

        return new RefusedEntity(issue.Type, HandleText(issue.Handle), issue.Line, issue.Rule.Id, reason);
    }

    public string Place(int line) => string.Create(CultureInfo.InvariantCulture, $"{placeWord} {line}");

    public IReadOnlyList<Diagnostic> ToList()
    {
        var result = new List<Diagnostic>(_diagnostics);
        foreach (var (rule, count) in _counts.Where(entry => entry.Value > ShownPerRule).OrderBy(entry => entry.Key.Id, StringComparer.Ordinal))
        {
            result.Add(DxfRules.MoreOfTheSame.At(default, rule.Id, NumberText.Whole(count), NumberText.Whole(ShownPerRule)));
        }

        return result;
    }

    /// <summary>The text that follows "was left out:" in the sentence of the rule.</summary>
    private static string Reason(in RecordIssue issue)
    {
        var sentence = issue.Rule.At(default, issue.Type, "", issue.Detail).Sentence;
        return sentence[(sentence.IndexOf(": ", StringComparison.Ordinal) + 2)..];
    }

    private static string? HandleText(ulong handle) => handle == 0 ? null : handle.ToString("X", CultureInfo.InvariantCulture);

    private bool Counted(DiagnosticRule rule)
    {
        var count = _counts.GetValueOrDefault(rule) + 1;
        _counts[rule] = count;
        return count <= ShownPerRule;
    }
}
