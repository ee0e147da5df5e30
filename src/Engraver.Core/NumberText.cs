using System.Globalization;

namespace Engraver.Core;

/// <summary>Numbers as text for machines, files and the facts of messages: with a point and, unless stated, without an exponent.</summary>
public static class NumberText
{
    private const int MaxDecimals = 10;

    private static readonly string[] s_rounded = Formats('#');
    private static readonly string[] s_fixed = Formats('0');

    /// <summary>With at most so many decimals, 0 to 10; trailing zeros are omitted.</summary>
    public static string Rounded(double value, int decimals) => value.ToString(s_rounded[decimals], CultureInfo.InvariantCulture);

    /// <summary>The same, with 0 instead of -0 for a negative number that is rounded to zero.</summary>
    public static string RoundedWithoutMinusZero(double value, int decimals) => Rounded(value, decimals) is var text && text == "-0" ? "0" : text;

    /// <summary>With exactly so many decimals.</summary>
    public static string Fixed(double value, int decimals) => value.ToString(s_fixed[decimals], CultureInfo.InvariantCulture);

    /// <summary>The shortest text from which the same number is read; very large and very small numbers have an exponent.</summary>
    public static string Exact(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>A whole number, without separators of thousands.</summary>
    public static string Whole(long value) => value.ToString(CultureInfo.InvariantCulture);

    private static string[] Formats(char digit) => [.. Enumerable.Range(0, MaxDecimals + 1).Select(decimals => "0." + new string(digit, decimals))];
}
