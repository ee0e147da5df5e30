using System.Globalization;
using System.Text;

namespace Engraver.Workbench.SerialTexts;

/// <summary>Writes characters into the string of a text so that its codes are not read in them (docs/text-codes.md).</summary>
/// <remarks><c>\U+XXXX</c> is a character and nothing else in a TEXT, in an MTEXT and in the stacks of an MTEXT, therefore the type of the text does not
/// matter.</remarks>
internal static class LiteralText
{
    /// <summary>A code before the field is not longer than this.</summary>
    private const int LongestCode = 24;

    /// <param name="text">The string up to the value.</param>
    /// <param name="value">The characters to engrave; line feed and tab have their meaning.</param>
    public static void Append(StringBuilder text, string value)
    {
        SeparateCode(text);
        var start = text.Length;
        var mayContinue = EndsInCode(text);
        foreach (var unit in value.ReplaceLineEndings("\n"))
        {
            var isFirst = text.Length == start && mayContinue;
            if (!isFirst && (char.IsLetterOrDigit(unit) || char.IsSurrogate(unit) || unit is ' ' or '\n' or '\t' or '.' or ',' or '-' or '+' or ':')) text.Append(unit);
            else AppendEscaped(text, unit);
        }
    }

    /// <summary>A backslash or a caret at the end, which has no code after it, becomes a character.</summary>
    private static void SeparateCode(StringBuilder text)
    {
        if (text.Length == 0 || text[^1] is not ('\\' or '^')) return;
        var (last, count) = (text[^1], 1);
        while (count < text.Length && text[^(count + 1)] == last) count++;
        if (count % 2 == 0) return; // pairs of them are complete
        text.Length--;
        AppendEscaped(text, last);
    }

    /// <summary>True where the first character of the value might continue a code: %%0, \H2.</summary>
    private static bool EndsInCode(StringBuilder text)
    {
        var tail = text.ToString(Math.Max(0, text.Length - LongestCode), Math.Min(LongestCode, text.Length)).AsSpan();
        return tail[(tail.LastIndexOfAny(' ', ';') + 1)..].IndexOfAny('%', '^', '\\') >= 0;
    }

    private static void AppendEscaped(StringBuilder text, char unit) => text.Append("\\U+").Append(((int)unit).ToString("X4", CultureInfo.InvariantCulture));
}
