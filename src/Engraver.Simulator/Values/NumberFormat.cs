using System.Globalization;

namespace Engraver.Simulator.Values;

/// <summary>Print format of a number: digits before and after the point, padded or not, decimal or hexadecimal (galil-dmc.md A.3 format commands, E
/// messages).</summary>
/// <param name="Digits">Places before the point.</param>
/// <param name="Decimals">Places after the point, rounded: a number given with up to four decimals prints as given, although 0.6 is stored as 0.59999 (4.1
/// with {F5.2} prints 00004.10, E Messages).</param>
/// <param name="LeadingZeros">True when unused places before the point print as zeros.</param>
/// <param name="Hex">True for hexadecimal with a dollar sign.</param>
internal readonly record struct NumberFormat(int Digits, int Decimals, bool LeadingZeros, bool Hex)
{
    /// <summary>Characters of the longest number: sign or blank, ten digits, point, four decimals.</summary>
    public const int Longest = 20;

    private static readonly long[] Powers = [.. Enumerable.Range(0, 12).Select(n => (long)Math.Pow(10, n))];

    public static NumberFormat Variable => new(10, 4, false, false);

    public static NumberFormat Position => new(10, 0, false, false);

    /// <summary>Creates a format from the argument of PF and VF: m.n, negative m for hexadecimal.</summary>
    public static NumberFormat FromArgument(FixedPoint argument)
    {
        var (digits, decimals) = Math.DivRem((long)Math.Round(Math.Abs(argument.Value) * 10), 10);
        return digits is > 0 and <= 10 && decimals <= 4
            ? new((int)digits, (int)decimals, false, argument.Raw < 0)
            : throw new CommandRefusedException(Tc.OutOfRange);
    }

    /// <summary>The argument m.n of PF and VF, negative for hexadecimal: <c>PF ?</c>, <c>_PF</c>.</summary>
    public FixedPoint Argument => FixedPoint.FromDouble((Digits + (Decimals / 10.0)) * (Hex ? -1 : 1));

    /// <summary>The number with one column for its sign: a blank or a minus.</summary>
    public string Print(FixedPoint value)
    {
        Span<char> text = stackalloc char[Longest];
        return new string(text[..Write(text, value)]);
    }

    /// <summary>Writes the number into a buffer of at least <see cref="Longest"/> characters; returns the characters written.</summary>
    public int Write(Span<char> text, FixedPoint value)
    {
        text[0] = value.Raw < 0 && !Hex ? '-' : ' ';
        return 1 + (Hex ? WriteHex(text[1..], value) : WriteDecimal(text[1..], value));
    }

    private int WriteDecimal(Span<char> text, FixedPoint value)
    {
        // One unit of the last place. A literal loses less than 1/65536 when it is read, so rounding to four decimals restores the number as written.
        var unit = Powers[Decimals];
        var places = (long)((((Int128)Math.Abs(value.Raw) * unit) + (1 << 15)) >> 16);
        var (whole, fraction) = Math.DivRem(places, unit);
        if (whole > int.MaxValue && value.Raw > 0) (whole, fraction) = (int.MaxValue, unit - 1); // the largest number (E, Number)
        if (whole >= Powers[Digits]) (whole, fraction) = (Powers[Digits] - 1, unit - 1); // too large for its digits: prints as all nines (A.3 format commands)
        Span<char> zeros = stackalloc char[Digits];
        zeros.Fill('0');
        whole.TryFormat(text, out var length, LeadingZeros ? zeros : default, CultureInfo.InvariantCulture);
        if (Decimals == 0) return length;
        text[length++] = '.';
        for (var i = Decimals - 1; i >= 0; i--, fraction /= 10) text[length + i] = (char)('0' + (fraction % 10));
        return length + Decimals;
    }

    private int WriteHex(Span<char> text, FixedPoint value)
    {
        Span<char> digits = stackalloc char[12];
        ((ulong)value.Raw & 0xFFFF_FFFF_FFFF).TryFormat(digits, out _, "X12", CultureInfo.InvariantCulture);
        var whole = digits[Math.Max(0, 8 - Digits)..8];
        text[0] = '$';
        whole.CopyTo(text[1..]);
        if (Decimals == 0) return whole.Length + 1;
        text[whole.Length + 1] = '.';
        digits.Slice(8, Math.Min(4, Decimals)).CopyTo(text[(whole.Length + 2)..]);
        return whole.Length + 2 + Math.Min(4, Decimals);
    }
}
