using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Records;

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
    public void Add(in RecordIssue trouble)
    {
        if (trouble.Rule == DxfRules.WidthIgnored && _counts.ContainsKey(trouble.Rule)) return;
        if (!Counted(trouble.Rule)) return;
        var source = new SourceRef(trouble.Line, HandleText(trouble.Handle));
        _diagnostics.Add(trouble.Rule.At(source, trouble.Type, Place(trouble.Line), trouble.Detail));
    }

    /// <summary>The row of the balance sheet for a refused record. A million refusals for one reason share its text.</summary>
    public RefusedEntity Refusal(in RecordIssue trouble)
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
    private static string Reason(in RecordIssue trouble)
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

/// <summary>What is wrong with one record. Small, so that a hostile file can have a million of them; the sentence is made only when it is shown.</summary>
/// <param name="Rule">The row of the table; its facts are the type, the place and <paramref name="Detail"/>.</param>
/// <param name="Type">DXF type of the record.</param>
/// <param name="Handle">Handle as a number, 0 for none.</param>
/// <param name="Line">Line (binary: byte offset) at which the record, or what is wrong with it, stands.</param>
/// <param name="Detail">What the sentence needs besides; may be empty.</param>
/// <param name="Refused">True when the record is left out, false when it is taken all the same.</param>
internal readonly record struct RecordIssue(DiagnosticRule Rule, string Type, ulong Handle, int Line, string Detail, bool Refused)
{
    /// <summary>True when the damage need not be of this record alone, so that it is told even in a block that nothing uses: what has no name may have been the block's end, and all that follows is lost in it.</summary>
    public bool ConcernsMore => Rule == DxfRules.NameDamaged;
}
