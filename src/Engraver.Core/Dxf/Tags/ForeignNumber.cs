using System.Buffers;
using System.Text;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Numbers that are not valid in a DXF but occur: a decimal comma (12,5), a Fortran exponent (1.25D+01, also in small letters).</summary>
internal static class ForeignNumber
{
    private const int Longest = 64;
    private static readonly SearchValues<byte> NumberBytes = SearchValues.Create("0123456789+-.,dDeE"u8);

    /// <summary>True when the text has exactly one such meaning. "1,234.5" and "1,2,3" have none: DXF has no thousands separators.</summary>
    public static bool TryParse(ReadOnlySpan<byte> text, out double value)
    {
        value = 0.0;
        var trimmed = text.Trim(" \t"u8);
        if (trimmed.IsEmpty || trimmed.Length > Longest || trimmed.IndexOfAnyExcept(NumberBytes) >= 0) return false;
        var spelled = Encoding.ASCII.GetString(trimmed);
        var commas = spelled.Count(letter => letter == ',');
        if (commas > 1 || (commas == 1 && spelled.Contains('.', StringComparison.Ordinal))) return false;
        var usual = spelled.Replace(',', '.').Replace('D', 'E').Replace('d', 'e');
        return usual.Any(char.IsAsciiDigit) && DxfNumber.TryParse(Encoding.ASCII.GetBytes(usual), out value);
    }
}
