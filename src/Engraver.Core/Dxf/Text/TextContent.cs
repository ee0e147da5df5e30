using System.Text;
using Engraver.Core.TextMarkup;

namespace Engraver.Core.Dxf.Text;

/// <summary>A text value in readable form: %% codes and caret codes resolved, the formatting of an MTEXT removed (DXF reference, "TEXT", "MTEXT").</summary>
internal static class TextContent
{
    /// <summary>The content of TEXT and ATTRIB: one line.</summary>
    public static string OfText(string raw) => Carets(Percents(raw)).Replace('\n', ' ');

    /// <summary>The content of MTEXT: \P separates lines, braces group, every other code is formatting.</summary>
    public static string OfMText(string raw)
    {
        var text = Carets(Percents(raw));
        var result = new StringBuilder(text.Length);
        var lastEnd = text.LastIndexOf(';'); // computed once: a malicious text may begin a million codes and end none
        for (var at = 0; at < text.Length; at++)
        {
            if (text[at] is '{' or '}') continue;
            if (text[at] != '\\' || at + 1 == text.Length) result.Append(text[at]);
            else at = Code(text, at + 1, lastEnd, result);
        }

        return result.ToString();
    }

    /// <summary>Handles the code whose letter is at <paramref name="at"/>; returns the index of its last character. No code ends after
    /// <paramref name="lastEnd"/>.</summary>
    private static int Code(string text, int at, int lastEnd, StringBuilder result)
    {
        switch (text[at])
        {
            case 'P' or 'X' or 'N':
                result.Append('\n');
                return at;
            case '~':
                result.Append('\u00A0');
                return at;
            case '\\' or '{' or '}':
                result.Append(text[at]);
                return at;
            case 'L' or 'l' or 'O' or 'o' or 'K' or 'k':
                return at;
            case 'S':
                return at < lastEnd ? Stack(text, at, result) : at;
            case 'A' or 'C' or 'c' or 'F' or 'f' or 'H' or 'Q' or 'T' or 'W' or 'p':
                return at < lastEnd ? text.IndexOf(';', at) : at;
            default:
                result.Append('\\').Append(text[at]); // not a code: kept as text
                return at;
        }
    }

    /// <summary>\S upper ^ lower; (or / or #): a stacked fraction becomes "upper/lower", with one side empty the other alone.</summary>
    private static int Stack(string text, int at, StringBuilder result)
    {
        var end = text.IndexOf(';', at);
        var fraction = text[(at + 1)..end];
        var bar = fraction.AsSpan().IndexOfAny('^', '/', '#');
        var (upper, lower) = bar < 0 ? (fraction, "") : (fraction[..bar].Trim(), fraction[(bar + 1)..].Trim());
        result.Append(upper).Append(upper.Length > 0 && lower.Length > 0 ? "/" : "").Append(lower);
        return end;
    }

    /// <summary>%%c diameter, %%d degree, %%p plus-minus, %%nnn a character by number; %%u %%o %%k switch lines on and off.</summary>
    private static string Percents(string text)
    {
        if (!text.Contains("%%", StringComparison.Ordinal)) return text;
        var result = new StringBuilder(text.Length);
        for (var at = 0; at < text.Length;)
        {
            var length = SpecialCharacters.PercentLength(text, at, out var character, out _, out var number);
            if (length == 0) result.Append(text[at]);
            else if (number < 0) result.Append(character);
            else if (number is < 128 or >= 160) result.Append((char)number);
            at += Math.Max(length, 1);
        }

        return result.ToString();
    }

    /// <summary>^I tab, ^J line feed, ^M return (removed), ^ and a blank: a caret.</summary>
    private static string Carets(string text) => !text.Contains('^', StringComparison.Ordinal)
        ? text
        : text.Replace("^I", "\t", StringComparison.Ordinal).Replace("^J", "\n", StringComparison.Ordinal).Replace("^M", "", StringComparison.Ordinal).Replace("^ ", "^", StringComparison.Ordinal);
}
