using System.Globalization;

namespace Engraver.Samples.Dxf;

/// <summary>How coordinates become text. Rounding first keeps "-0" and the last unit of a platform's sine out of the files.</summary>
internal sealed record RealFormat
{
    private const int DigitsOfExactText = 17;
    private readonly int? decimals;
    private readonly string pattern;

    private RealFormat(int? decimals, string pattern) => (this.decimals, this.pattern) = (decimals, pattern);

    /// <summary>Up to nine decimals, no trailing zeros: arc ends computed from the text agree with the neighbour within 1e-8 at these sizes.</summary>
    public static RealFormat Trimmed { get; } = new(9, "0.0########");

    /// <summary>A fixed number of decimals (1 to 15), or 17 for the exact text of the double.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Any other number of digits.</exception>
    public static RealFormat OfDigits(int digits) => digits switch
    {
        DigitsOfExactText => new(null, "G17"),
        >= 1 and <= 15 => new(digits, "F" + digits.ToString(CultureInfo.InvariantCulture)),
        _ => throw new ArgumentOutOfRangeException(nameof(digits), digits, "Digits are 1 to 15 decimals, or 17 for exact text."),
    };

    public double Round(double value) => decimals is { } count ? Math.Round(value, count) + 0.0 : value;

    public string Text(double value) => Round(value).ToString(pattern, CultureInfo.InvariantCulture);
}
