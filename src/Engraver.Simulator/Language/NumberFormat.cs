using System.Globalization;

namespace Engraver.Simulator.Language;

/// <summary>How a number is printed: digits before and after the point, padded or not, decimal or hexadecimal (galil-dmc.md A.3 format commands, E messages).</summary>
/// <param name="Digits">Places before the point.</param>
/// <param name="Decimals">Places after the point. Four are cut off (0.6 prints 0.5999), fewer are rounded (4.1 with {F5.2} prints 00004.10, E Messages).</param>
/// <param name="LeadingZeros">Whether unused places before the point print as zeros.</param>
/// <param name="Hex">Hexadecimal with a dollar sign.</param>
internal readonly record struct NumberFormat(int Digits, int Decimals, bool LeadingZeros, bool Hex)
{
    private const int LeastCutDecimals = 4;

    public static NumberFormat Variable => new(10, 4, false, false);

    public static NumberFormat Position => new(10, 0, false, false);

    /// <summary>From the argument of PF and VF: m.n, negative m for hexadecimal.</summary>
    public static NumberFormat FromArgument(FixedPoint argument)
    {
        var digits = Math.Abs(argument.Integer);
        var decimals = (int)Math.Round((Math.Abs(argument.Value) - digits) * 10);
        return digits is > 0 and <= 10 && decimals <= 4
            ? new(digits, decimals, false, argument.Raw < 0)
            : throw new CommandRefusedException(Tc.OutOfRange);
    }

    /// <summary>The number with one column for the sign: a blank or a minus.</summary>
    public string Print(FixedPoint value) => (value.Raw < 0 && !Hex ? "-" : " ") + PrintMagnitude(value);

    private string PrintMagnitude(FixedPoint value)
    {
        if (Hex) return PrintHex(value);

        // One unit of the last place; the stored fraction is coarser than four decimals, so rounding those would invent digits.
        var unit = (long)Math.Pow(10, Decimals);
        Int128 scaled = (Int128)Math.Abs(value.Raw) * unit + (Decimals < LeastCutDecimals ? 1 << 15 : 0);
        var places = (long)(scaled >> 16);
        var whole = (places / unit).ToString(CultureInfo.InvariantCulture);
        if (whole.Length > Digits)
            return new string('9', Digits) + (Decimals > 0 ? "." + new string('9', Decimals) : "");

        var fraction = Decimals == 0 ? "" : "." + (places % unit).ToString(CultureInfo.InvariantCulture).PadLeft(Decimals, '0');
        return (LeadingZeros ? whole.PadLeft(Digits, '0') : whole) + fraction;
    }

    private string PrintHex(FixedPoint value)
    {
        var whole = ((uint)(value.Raw >> 16)).ToString("X8", CultureInfo.InvariantCulture);
        whole = whole.Length > Digits ? whole[^Digits..] : whole;
        var fraction = ((uint)value.Raw & 0xFFFF).ToString("X4", CultureInfo.InvariantCulture);
        return "$" + whole + (Decimals > 0 ? "." + fraction[..Math.Min(4, Decimals)] : "");
    }
}
