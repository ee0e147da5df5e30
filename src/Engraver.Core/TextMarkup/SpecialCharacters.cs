using System.Globalization;

namespace Engraver.Core.TextMarkup;

/// <summary>The codes that TEXT and MTEXT have in common: %% codes and control characters with a caret (DXF reference, "TEXT"; AutoCAD's help, "Control Codes
/// and Special Text Characters").</summary>
internal static class SpecialCharacters
{
    private const string Diameter = "\u2300";
    private const string Degree = "\u00B0";
    private const string PlusMinus = "\u00B1";
    private const int WesternCodePage = 1252;

    /// <summary>Length of the %% code that begins here; 0 when none does.</summary>
    /// <param name="character">Its character; "" for a switch of marks.</param>
    /// <param name="number">The number of a %%nnn; -1 for every other code.</param>
    public static int PercentLength(string text, int at, out string character, out LineMarks switched, out int number)
    {
        (character, switched, number) = ("", LineMarks.None, -1);
        if (at + 2 >= text.Length || text[at] != '%' || text[at + 1] != '%') return 0;
        switch (char.ToLowerInvariant(text[at + 2]))
        {
            case 'c':
                character = Diameter;
                return 3;
            case 'd':
                character = Degree;
                return 3;
            case 'p':
                character = PlusMinus;
                return 3;
            case '%':
                character = "%";
                return 3;
            case 'u':
                switched = LineMarks.Underline;
                return 3;
            case 'o':
                switched = LineMarks.Overline;
                return 3;
            case 'k':
                switched = LineMarks.StrikeThrough;
                return 3;
            default:
                if (at + 5 > text.Length || !byte.TryParse(text.AsSpan(at + 2, 3), NumberStyles.None, CultureInfo.InvariantCulture, out var code)) return 0;
                (character, number) = (OfNumber(code), code);
                return 5;
        }
    }

    /// <summary>True for a caret that is a code: a control character (^@ to ^_) or, with a blank, the caret itself.</summary>
    /// <param name="character">The character; U+0000 to U+001F, or ^.</param>
    public static bool IsCaretCode(string text, int at, out char character)
    {
        character = '^';
        if (at + 1 >= text.Length || text[at] != '^') return false;
        var letter = text[at + 1];
        if (letter == ' ') return true;
        character = (char)(letter - '@');
        return letter is >= '@' and <= '_';
    }

    /// <summary>The character of %%nnn in the code page 1252. 127 to 129 are degree, plus-minus and diameter, which AutoCAD's stroke fonts have at these
    /// numbers. "" for a number without a character.</summary>
    private static string OfNumber(byte number) => number switch
    {
        < 32 => "",
        127 => Degree,
        128 => PlusMinus,
        129 => Diameter,
        _ => Printed(CharacterEscapes.OfByte(number, WesternCodePage)),
    };

    private static string Printed(string character) => char.IsControl(character, 0) ? "" : character;
}
