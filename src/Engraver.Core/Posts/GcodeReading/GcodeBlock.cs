using System.Globalization;
using System.Text;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>One line of RS-274: words of a letter and a number, without its comments (rs274-hpgl.md 1.1). Spaces and tabs mean nothing, not even inside a
/// number; small letters equal capitals.</summary>
internal sealed class GcodeBlock
{
    /// <summary>Letters that are allowed in a line; G and M several times.</summary>
    private const string Known = "NGMFSXYZIJKRPQT";

    private readonly List<GcodeWord> _words = [];

    private GcodeBlock()
    {
    }

    public IReadOnlyList<GcodeWord> Words => _words;

    /// <summary>The line is the mark %.</summary>
    public bool IsMark { get; private init; }

    /// <summary>Number of characters that a controller stores: without spaces and comments.</summary>
    public int Length { get; private set; }

    /// <summary>The codes of a letter in tenths, G91.1 as 911, in their order.</summary>
    public IEnumerable<int> Codes(char letter) => _words.Where(word => word.Letter == letter).Select(word => (int)Math.Round(word.Value * 10.0));

    /// <summary>The number after a letter; null when the letter is missing.</summary>
    public double? this[char letter] => _words.Where(word => word.Letter == letter).Select(word => (double?)word.Value).FirstOrDefault();

    public bool Has(string letters) => _words.Any(word => letters.Contains(word.Letter, StringComparison.Ordinal));

    /// <returns>Null when it is not a line of RS-274, with the reason.</returns>
    public static GcodeBlock? Parse(string line, out string reason)
    {
        if (Bare(line, out reason) is not { } text) return null;
        if (text == "%") return new GcodeBlock { IsMark = true, Length = 1 };
        var block = new GcodeBlock { Length = text.Length };
        for (var at = 0; at < text.Length;)
        {
            var letter = char.ToUpperInvariant(text[at++]);
            if (Refusal(letter) is { } refusal) reason = refusal;
            else if (at < text.Length && text[at] is '#' or '[') reason = Wording.Get("GcodeReader.ParameterNotSupported");
            else if (block.Has(letter.ToString()) && letter is not ('G' or 'M')) reason = Wording.Get("GcodeReader.WordTwice", letter);
            else if (letter == 'N' && block._words.Count > 0) reason = Wording.Get("GcodeReader.LineNumberNotFirst");
            if (reason.Length > 0) return null;
            var from = at;
            while (at < text.Length && (char.IsAsciiDigit(text[at]) || text[at] == '.' || (at == from && text[at] is '+' or '-'))) at++;
            if (Number(text[from..at]) is not { } value)
            {
                reason = Wording.Get("GcodeReader.NumberExpected", letter, Shown(text[from..at]));
                return null;
            }

            block._words.Add(new GcodeWord(letter, value));
        }

        return block;
    }

    /// <summary>Without spaces and comments.</summary>
    private static string? Bare(string line, out string reason)
    {
        var (text, isComment) = (new StringBuilder(line.Length), false);
        reason = "";
        foreach (var sign in line)
        {
            if (isComment)
            {
                if (sign == '(') reason = Wording.Get("GcodeReader.CommentInComment");
                isComment = sign != ')';
            }
            else if (sign == ';')
            {
                break;
            }
            else if (sign == '(')
            {
                isComment = true;
            }
            else if (sign is not (' ' or '\t' or '\r'))
            {
                text.Append(sign);
            }
        }

        if (isComment && reason.Length == 0) reason = Wording.Get("GcodeReader.CommentNotClosed");
        return reason.Length == 0 ? text.ToString() : null;
    }

    private static string? Refusal(char letter) => letter switch
    {
        '#' => Wording.Get("GcodeReader.ParameterNotSupported"),
        'O' => Wording.Get("GcodeReader.OWordsNotSupported"),
        '/' => Wording.Get("GcodeReader.BlockDelete"),
        _ => Known.Contains(letter, StringComparison.Ordinal) ? null : Wording.Get("GcodeReader.WordNotSupported", Shown(letter.ToString())),
    };

    /// <summary>A sign, digits and at most one point, at least one digit; no exponent.</summary>
    private static double? Number(string text) =>
        text.Any(char.IsAsciiDigit) && text.Count(sign => sign == '.') <= 1 && double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var value) && double.IsFinite(value) ? value : null;

    private static string Shown(string text) => text.Length <= 20 ? text : text[..20];
}

/// <summary>A letter and its number.</summary>
internal readonly record struct GcodeWord(char Letter, double Value);
