using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>Collects findings, of each rule the first hundred; the rest are counted and summed up in one line.</summary>
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

    /// <summary>Adds a finding about a record. That widths are ignored is said once, however many polylines have one.</summary>
    public void Add(in Trouble trouble)
    {
        if (trouble.Rule == DxfRules.WidthIgnored && _counts.ContainsKey(trouble.Rule)) return;
        if (!Counted(trouble.Rule)) return;
        var source = new SourceRef(trouble.Line, HandleText(trouble.Handle));
        _diagnostics.Add(trouble.Rule.At(source, trouble.Type, Place(trouble.Line), trouble.Detail));
    }

    /// <summary>The row of the balance sheet for a refused record. A million refusals for one reason share its text.</summary>
    public RefusedEntity Refusal(in Trouble trouble)
    {
        if (trouble.Detail.Length > 0 || !_reasons.TryGetValue(trouble.Rule, out var reason))
        {
            reason = Reason(trouble);
            if (trouble.Detail.Length == 0) _reasons.Add(trouble.Rule, reason);
        }

        return new RefusedEntity(trouble.Type, HandleText(trouble.Handle), trouble.Line, trouble.Rule.Id, reason);
    }

    public string Place(int line) => string.Create(CultureInfo.InvariantCulture, $"{placeWord} {line}");

    public IReadOnlyList<Diagnostic> ToList()
    {
        var result = new List<Diagnostic>(_diagnostics);
        foreach (var (rule, count) in _counts.Where(entry => entry.Value > ShownPerRule).OrderBy(entry => entry.Key.Id, StringComparer.Ordinal))
        {
            result.Add(DxfRules.MoreOfTheSame.At(default, rule.Id, Text(count), Text(ShownPerRule)));
        }

        return result;
    }

    /// <summary>What follows "was left out:" in the sentence of the rule.</summary>
    private static string Reason(in Trouble trouble)
    {
        var sentence = trouble.Rule.At(default, trouble.Type, "", trouble.Detail).Sentence;
        return sentence[(sentence.IndexOf(": ", StringComparison.Ordinal) + 2)..];
    }

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static string? HandleText(ulong handle) => handle == 0 ? null : handle.ToString("X", CultureInfo.InvariantCulture);

    private bool Counted(DiagnosticRule rule)
    {
        var count = _counts.GetValueOrDefault(rule) + 1;
        _counts[rule] = count;
        return count <= ShownPerRule;
    }
}
