using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Numbers and texts as written in statements (galil-dmc.md A.3 Numbers, E).</summary>
internal static class NumberLiteral
{
    private const long LargestWhole = 2147483648; // one above the largest number: only its negative exists, which wrapping to 48 bits gives

    /// <summary>A decimal number, or a hexadecimal one after a dollar sign; digits below 1/65536 are cut off (0.6 becomes 0.59999).</summary>
    /// <param name="length">Characters read.</param>
    public static FixedPoint Read(ReadOnlySpan<char> text, out int length)
    {
        if (text[0] == '$') return ReadHex(text, out length);

        length = 0;
        long whole = 0;
        while (length < text.Length && char.IsAsciiDigit(text[length]))
        {
            whole = Math.Min((whole * 10) + (text[length++] - '0'), LargestWhole + 1);
        }

        var digits = length;
        long fraction = 0;
        if (length < text.Length && text[length] == '.')
        {
            length++;
            fraction = ReadFraction(text, ref length);
            digits = length - 1;
        }

        return digits == 0 || whole > LargestWhole
            ? throw new CommandRefusedException(Tc.OutOfRange)
            : new FixedPoint((whole << 16) | fraction) + FixedPoint.Zero;
    }

    /// <summary>Up to six characters, first one in the highest byte (E, Variable).</summary>
    public static FixedPoint PackText(ReadOnlySpan<char> value)
    {
        if (value.Length > 6) throw new CommandRefusedException(Tc.BadString);

        long raw = 0;
        for (var i = 0; i < 6; i++) raw = (raw << 8) | (byte)(i < value.Length ? value[i] : 0);

        return new FixedPoint((raw << 16) >> 16);
    }

    private static long ReadFraction(ReadOnlySpan<char> text, ref int position)
    {
        long digits = 0;
        long scale = 1;
        for (; position < text.Length && char.IsAsciiDigit(text[position]); position++)
        {
            if (scale < 1_000_000_000)
            {
                digits = (digits * 10) + (text[position] - '0');
                scale *= 10;
            }
        }

        return (digits << 16) / scale;
    }

    private static FixedPoint ReadHex(ReadOnlySpan<char> text, out int length)
    {
        uint whole = 0;
        for (length = 1; length < text.Length && char.IsAsciiHexDigitUpper(text[length]); length++)
        {
            whole = (whole << 4) | (uint)Convert.ToInt32(text[length].ToString(), 16);
        }

        long fraction = 0;
        if (length < text.Length && text[length] == '.')
        {
            length++;
            for (var shift = 12; length < text.Length && char.IsAsciiHexDigitUpper(text[length]); length++, shift -= 4)
            {
                fraction |= shift < 0 ? 0 : (long)Convert.ToInt32(text[length].ToString(), 16) << shift;
            }
        }

        return new FixedPoint(((long)(int)whole << 16) | fraction);
    }
}
