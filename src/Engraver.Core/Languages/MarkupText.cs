using System.Net;

namespace Engraver.Core.Languages;

/// <summary>Foreign text (names of files, layers, texts of a drawing) inside XML or HTML: what it says is shown and never obeyed.</summary>
public static class MarkupText
{
    /// <summary>The text with <c>&lt; &gt; &amp;</c> and both quotes as character references, and without the letters that XML does not allow. Safe between tags and between the quotes of an attribute.</summary>
    public static string Escaped(string text) => WebUtility.HtmlEncode(string.Concat(text.Where(IsAllowed)));

    private static bool IsAllowed(char letter) => !char.IsControl(letter) && letter is not ('\uFFFE' or '\uFFFF');
}
