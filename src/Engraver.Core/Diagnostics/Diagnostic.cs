using System.Text;

namespace Engraver.Core.Diagnostics;

/// <summary>One finding about a drawing or a setting: permanent id, severity, one sentence that says what, where and what to do.</summary>
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
