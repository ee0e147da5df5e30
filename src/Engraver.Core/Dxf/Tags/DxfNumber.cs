using System.Globalization;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Numbers as an ASCII DXF writes them: decimal point, optional sign and exponent, blanks around them. No comma, no NaN, no infinity.</summary>
internal static class DxfNumber
{
    /// <summary>A larger number is refused in every group.</summary>
    public const double Largest = Drawing.LargestCoordinate;

    private const ulong LargestExactMantissa = 1UL << 53;

    /// <summary>Maximum number of decimal digits that fit 64 bits.</summary>
    private const int MaxDigits = 19;

    /// <summary>Longest number for the fast path, with sign and point.</summary>
    private const int LongestPlain = MaxDigits + 2;

    /// <summary>10^0 to 10^22: the powers of ten that a double holds exactly.</summary>
    private static readonly double[] PowersOfTen =
    [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    ];

    /// <summary>The nearest double, as <see cref="double.Parse(string)"/> would give it; false when the text is not a usable number.</summary>
    public static bool TryParse(ReadOnlySpan<byte> text, out double value) => TryPlain(text, out value) || TryAny(text, out value);

    /// <summary>Reads sign, digits and a point, as almost every number is written; false when the general method is needed.</summary>
    private static bool TryPlain(ReadOnlySpan<byte> text, out double value)
    {
        value = 0.0;
        if (text.Length is 0 or > LongestPlain) return false;
        var negative = text[0] == '-';
        var digits = negative ? 1 : 0;
        var point = text.Length;
        var mantissa = 0UL;
        for (var at = digits; at < text.Length; at++)
        {
            var digit = (uint)text[at] - '0';
            if (digit <= 9) mantissa = (mantissa * 10) + digit;
            else if (text[at] == '.' && point == text.Length) point = at;
            else return false;
        }

        var decimals = Math.Max(0, text.Length - point - 1);
        if (text.Length - digits - (point < text.Length ? 1 : 0) is 0 or > MaxDigits) return false;
        if (mantissa <= LargestExactMantissa) value = mantissa / PowersOfTen[decimals];
        else if (!DecimalQuotient.TryRound(mantissa, decimals, out value)) return false;
        if (negative) value = -value;
        return true;
    }

    private static bool TryAny(ReadOnlySpan<byte> text, out double value)
    {
        var digits = text.Trim(" \t"u8);
        return Scan(digits, out var mantissa, out var exponent, out var exact) && (exact
            ? Scaled(mantissa, exponent, digits[0] == '-', out value)
            : double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && Math.Abs(value) <= Largest)
            || Fail(out value);
    }

    private static bool Fail(out double value)
    {
        value = 0.0;
        return false;
    }

    /// <summary>A mantissa below 2^53 times or over an exact power of ten is one correctly rounded operation (Clinger 1990, fast path).</summary>
    private static bool Scaled(ulong mantissa, int exponent, bool negative, out double value)
    {
        value = exponent < 0 ? mantissa / PowersOfTen[-exponent] : mantissa * PowersOfTen[exponent];
        if (negative) value = -value;
        return true;
    }

    /// <summary>Checks the grammar and collects mantissa and decimal exponent; <paramref name="exact"/> states whether the fast path may be taken.</summary>
    private static bool Scan(ReadOnlySpan<byte> text, out ulong mantissa, out int exponent, out bool exact)
    {
        mantissa = 0;
        exponent = 0;
        exact = false;
        var at = text.Length > 0 && text[0] is (byte)'-' or (byte)'+' ? 1 : 0;
        var first = at;
        at = Digits(text, at, ref mantissa);
        var count = at - first;
        if (at < text.Length && text[at] == '.')
        {
            var point = ++at;
            at = Digits(text, at, ref mantissa);
            exponent = point - at;
            count -= exponent;
        }

        if (count == 0) return false;
        if (at < text.Length && !Exponent(text[at..], ref exponent)) return false;
        exact = count <= 19 && mantissa <= LargestExactMantissa && Math.Abs(exponent) < PowersOfTen.Length;
        return true;
    }

    /// <summary>Appends digits to the mantissa. Nineteen fit; more overflow deliberately, since a longer number does not use the fast path.</summary>
    private static int Digits(ReadOnlySpan<byte> text, int at, ref ulong mantissa)
    {
        var value = mantissa;
        for (; at < text.Length; at++)
        {
            var digit = (uint)text[at] - '0';
            if (digit > 9) break;
            value = unchecked((value * 10) + digit);
        }

        mantissa = value;
        return at;
    }

    private static bool Exponent(ReadOnlySpan<byte> text, ref int exponent)
    {
        if (text[0] is not ((byte)'e' or (byte)'E')) return false;
        var negative = text.Length > 1 && text[1] == '-';
        var at = text.Length > 1 && text[1] is (byte)'-' or (byte)'+' ? 2 : 1;
        if (at == text.Length) return false;
        var size = 0;
        for (; at < text.Length; at++)
        {
            var digit = text[at] - '0';
            if (digit is < 0 or > 9) return false;
            size = Math.Min((size * 10) + digit, 100_000); // far beyond any double; keeps the count from overflowing
        }

        exponent += negative ? -size : size;
        return true;
    }
}
