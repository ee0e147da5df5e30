using System.Globalization;
using System.Text;

namespace Engraver.Core.Languages;

/// <summary>A language for tests, <c>qps-ploc</c>: every text of the resources is in ⟦brackets⟧ with an accent on each letter, every fact in ‹marks›. A plain
/// letter outside of marks does not come from the resources.</summary>
public static class PseudoLanguage
{
    public const string CultureName = "qps-ploc";

    private const string Small = "åƀçðéƒĝĥîĵķļɱñöþǫŕšţûṽŵẋýž";
    private const string Large = "ÅƁÇÐÉƑĜĤÎĴĶĻḾÑÖÞǪŔŠŢÛṼŴẊÝŽ";

    /// <summary>True when this language is the current one.</summary>
    public static bool IsCurrent => string.Equals(CultureInfo.CurrentUICulture.Name, CultureName, StringComparison.OrdinalIgnoreCase);

    /// <summary>Formats facts as the invariant culture does and marks those that have letters.</summary>
    internal static IFormatProvider Facts { get; } = new FactFormat();

    /// <summary>The text with accents. A fact's place in {braces} and a setting's key in [brackets] are not changed.</summary>
    public static string Write(string english)
    {
        ArgumentNullException.ThrowIfNull(english);
        var text = new StringBuilder("⟦", english.Length + 2);
        var closing = '\0';
        foreach (var letter in english)
        {
            text.Append(closing == '\0' ? Accented(letter) : letter);
            if (closing == '\0' && letter is '{' or '[') closing = letter == '{' ? '}' : ']';
            else if (letter == closing) closing = '\0';
        }

        return text.Append('⟧').ToString();
    }

    /// <summary>The fact in marks; unchanged when it has no letter or is a text itself.</summary>
    public static string Mark(string fact)
    {
        ArgumentNullException.ThrowIfNull(fact);
        return fact.Any(char.IsAsciiLetter) && !fact.Contains('⟦', StringComparison.Ordinal) ? $"‹{fact}›" : fact;
    }

    /// <summary>Every word of plain letters outside of marks and [brackets]; a test expects none.</summary>
    public static IReadOnlyList<string> UnmarkedWords(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var found = new List<string>();
        var (depth, begin) = (0, -1);
        for (var i = 0; i <= text.Length; i++)
        {
            var letter = i < text.Length ? text[i] : '\n';
            var plain = depth == 0 && char.IsAsciiLetter(letter);
            if (plain && begin < 0) begin = i;
            if (!plain && begin >= 0)
            {
                found.Add(text[begin..i]);
                begin = -1;
            }

            if (letter is '‹' or '[') depth++;
            if (letter is '›' or ']' && depth > 0) depth--;
        }

        return found;
    }

    private static char Accented(char letter) => letter switch
    {
        >= 'a' and <= 'z' => Small[letter - 'a'],
        >= 'A' and <= 'Z' => Large[letter - 'A'],
        _ => letter,
    };

    private sealed class FactFormat : IFormatProvider, ICustomFormatter
    {
        public object? GetFormat(Type? formatType) => formatType == typeof(ICustomFormatter) ? this : CultureInfo.InvariantCulture.GetFormat(formatType);

        public string Format(string? format, object? arg, IFormatProvider? formatProvider) =>
            Mark((arg is IFormattable value ? value.ToString(format, CultureInfo.InvariantCulture) : arg?.ToString()) ?? "");
    }
}
