using System.Net;
using System.Text;

namespace Engraver.Core.Languages;

/// <summary>Foreign text (names of files, layers, texts of a drawing) inside XML or HTML: it is shown and never interpreted as markup.</summary>
public static class MarkupText
{
    /// <summary>The text with <c>&lt; &gt; &amp;</c> and both quotes as character references, and without the characters that XML does not allow. Safe between
    /// tags and between the quotes of an attribute.</summary>
    public static string Escaped(string text) => WebUtility.HtmlEncode(string.Concat(text.Where(IsAllowed)));

    /// <summary>The text for a writer that does its own escaping: without the characters that XML does not allow, and with a replacement character for a single
    /// surrogate.</summary>
    public static string Allowed(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var allowed = new StringBuilder(text.Length);
        foreach (var letter in text.EnumerateRunes())
        {
            if (!letter.IsBmp || IsAllowed((char)letter.Value)) allowed.Append(letter);
        }

        return allowed.ToString();
    }

    private static bool IsAllowed(char letter) => !char.IsControl(letter) && letter is not ('\uFFFE' or '\uFFFF');
}
