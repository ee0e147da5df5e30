using System.Globalization;

namespace Engraver.Core.TextMarkup;

/// <summary>Numbers in the codes of an MTEXT: a sign, digits with a point, an exponent.</summary>
internal static class MTextNumber
{
    /// <summary>Length of the number at the start; 0 when none is there.</summary>
    public static int LengthAt(ReadOnlySpan<char> text)
    {
        var at = text is ['+' or '-', ..] ? 1 : 0;
        var first = at;
        at += Digits(text[at..]);
        var digits = at - first;
        if (at < text.Length && text[at] == '.')
        {
            var fraction = Digits(text[(at + 1)..]);
            digits += fraction;
            at += 1 + fraction;
        }

        if (digits == 0) return 0;
        if (at + 1 >= text.Length || text[at] is not ('e' or 'E')) return at;
        var sign = text[at + 1] is '+' or '-' ? 1 : 0;
        var exponent = Digits(text[(at + 1 + sign)..]);
        return exponent == 0 ? at : at + 1 + sign + exponent;
    }

    /// <summary>False for an empty text and for a number that is not finite.</summary>
    public static bool TryParse(ReadOnlySpan<char> text, out double value) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    private static int Digits(ReadOnlySpan<char> text) => text.IndexOfAnyExceptInRange('0', '9') is >= 0 and var length ? length : text.Length;
}
