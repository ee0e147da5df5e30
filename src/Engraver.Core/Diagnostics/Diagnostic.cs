using System.Text;

namespace Engraver.Core.Diagnostics;

/// <summary>A finding about a drawing or a setting: permanent id, severity, one sentence that says what, where and what to do.</summary>
public sealed record Diagnostic(DiagnosticRule Rule, SourceRef Source, IReadOnlyList<string> Facts)
{
    public string Id => Rule.Id;

    public Severity Severity => Rule.Severity;

    /// <summary>The sentence with its facts filled in, followed by the advice.</summary>
    public string Message => $"{Sentence} {Rule.Advice}";

    /// <summary>The sentence with its facts filled in.</summary>
    public string Sentence => Fill(Rule.Sentence, Facts);

    private static string Fill(string sentence, IReadOnlyList<string> facts)
    {
        var text = new StringBuilder();
        var names = new List<string>();
        for (var i = 0; i < sentence.Length; i++)
        {
            var close = sentence[i] == '{' ? sentence.IndexOf('}', i) : -1;
            if (close < 0)
            {
                text.Append(sentence[i]);
                continue;
            }

            var name = sentence[(i + 1)..close];
            if (!names.Contains(name)) names.Add(name);
            var place = names.IndexOf(name);
            text.Append(place < facts.Count ? facts[place] : "?");
            i = close;
        }

        return text.ToString();
    }
}

/// <summary>One row of the table that code, documentation and tests share.</summary>
/// <param name="Id">Permanent: never reused, never renumbered (DXF0007, SEQ0003).</param>
/// <param name="Severity">How bad it is.</param>
/// <param name="Sentence">What and where, with {names} for the facts of the case.</param>
/// <param name="Advice">What the operator can do. Settings are named by their keys in brackets, [max-error]; whoever shows the finding puts the option or command there (docs/settings.md).</param>
public sealed record DiagnosticRule(string Id, Severity Severity, string Sentence, string Advice)
{
    /// <summary>The finding for one case. <paramref name="facts"/> fill the {names} of the sentence in the order in which they first appear.</summary>
    public Diagnostic At(SourceRef source, params ReadOnlySpan<string> facts) => new(this, source, facts.ToArray());
}

/// <summary>How bad a finding is. <see cref="Error"/>: the file is unusable or truncated, or a curve is lost (exit code 1).</summary>
public enum Severity
{
    Info,
    Warning,
    Error,
}

/// <summary>Where in the drawing a finding is. <c>default</c> means the drawing as a whole.</summary>
/// <param name="Line">Line of an ASCII DXF (1 is the first), byte offset of a binary one; 0 when there is none.</param>
/// <param name="Handle">The entity's handle in the DXF's own hexadecimal spelling; null when it has none.</param>
public readonly record struct SourceRef(long Line, string? Handle = null);
