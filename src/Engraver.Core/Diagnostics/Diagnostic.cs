using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Languages;

namespace Engraver.Core.Diagnostics;

/// <summary>A finding about a drawing or a setting: permanent id, severity, and one sentence that states what happened, where and what to do.</summary>
public sealed record Diagnostic(DiagnosticRule Rule, SourceRef Source, IReadOnlyList<string> Facts)
{
    private readonly string? _advice;

    public string Id => Rule.Id;

    /// <summary>The point of the drawing that it concerns, millimetres; null where it does not concern a point, or concerns a whole entity.</summary>
    public Point2D? Place { get; init; }

    public Severity Severity => Rule.Severity;

    /// <summary>The sentence with its facts filled in, followed by the advice.</summary>
    public string Message => $"{Sentence} {Advice}";

    /// <summary>The sentence with its facts filled in.</summary>
    public string Sentence => Fill(TextName is null ? Rule.Sentence : Wording.Get(TextName));

    /// <summary>Name of the text of this case, with the same {names}; null for the rule's sentence.</summary>
    internal string? TextName { get; init; }

    /// <summary>The rule's advice, or the text that a caller with knowledge of the settings made of it.</summary>
    public string Advice
    {
        get => _advice ?? Rule.Advice;
        init => _advice = value;
    }

    private string Fill(string sentence)
    {
        var text = new StringBuilder();
        for (var i = 0; i < sentence.Length; i++)
        {
            var close = sentence[i] == '{' ? sentence.IndexOf('}', i) : -1;
            if (close < 0)
            {
                text.Append(sentence[i]);
                continue;
            }

            var place = Rule.FactNames.IndexOf(sentence[(i + 1)..close]);
            text.Append(place >= 0 && place < Facts.Count ? TextCatalogue.Fact(Visible(Facts[place])) : "?");
            i = close;
        }

        return text.ToString();
    }

    /// <summary>The fact with each control character as \x and its number: it may come from a damaged file, and a terminal would execute it.</summary>
    private static string Visible(string fact) =>
        fact.Any(char.IsControl) ? string.Concat(fact.Select(letter => char.IsControl(letter) ? string.Create(CultureInfo.InvariantCulture, $"\\x{(int)letter:X2}") : letter.ToString())) : fact;
}
