using System.Globalization;

namespace Engraver.Galil.Protocol;

/// <summary>Numbers as the controller prints them: separated by blanks or commas, with leading zeros, a point, or hexadecimal with a dollar sign (galil-dmc.md
/// A.3).</summary>
/// <remarks>The manuals differ on whether a blank separates two numbers of one MG (A.3): if only the sign column is between them, a minus follows the last
/// digit directly, <c>20000.0000-81.0000</c>.</remarks>
public static class ControllerNumber
{
    private static readonly char[] Separators = [' ', ',', '\t', '\r', '\n'];

    /// <summary>All numbers of a reply's data, in order.</summary>
    /// <returns>False when any part is not a number. Column widths are not used.</returns>
    public static bool TryParseAll(string data, out double[] values)
    {
        ArgumentNullException.ThrowIfNull(data);
        var numbers = new List<double>();
        values = [];
        foreach (var word in data.Split(Separators, StringSplitOptions.RemoveEmptyEntries))
        {
            if (!TryParseWord(word, numbers)) return false;
        }

        values = [.. numbers];
        return true;
    }

    /// <summary>One number, or several separated only by their signs.</summary>
    private static bool TryParseWord(string word, List<double> numbers)
    {
        for (var start = 0; start < word.Length;)
        {
            var sign = word.IndexOf('-', start + 1);
            var end = sign < 0 ? word.Length : sign;
            if (!TryParse(word[start..end], out var value)) return false;
            numbers.Add(value);
            start = end;
        }

        return true;
    }

    private static bool TryParse(string word, out double value) => word.StartsWith('$')
        ? TryParseHexadecimal(word.AsSpan(1), out value)
        : double.TryParse(word, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    /// <summary>$7FFFFFFF.FFFF: 32 bits in two's complement and a fraction of 1/65536.</summary>
    private static bool TryParseHexadecimal(ReadOnlySpan<char> digits, out double value)
    {
        var point = digits.IndexOf('.');
        var whole = point < 0 ? digits : digits[..point];
        var fraction = point < 0 ? "0" : digits[(point + 1)..];
        var ok = uint.TryParse(whole, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var high);
        ok &= ushort.TryParse(fraction, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var low);
        value = (int)high + (low / 65536.0);
        return ok;
    }
}
