using System.Numerics;

namespace Engraver.Core.Dxf.Tags;

/// <summary>The double nearest to a whole number over a power of ten, where neither fits a double exactly: coordinates written with 16 or 17 digits.</summary>
/// <remarks>
/// Multiplies by a reciprocal of 128 bits (Lemire, Number parsing at a gigabyte per second, 2021). The reciprocal is truncated, so the product may be one too
/// small in its 128th bit; where that could matter (or the value is exactly between two doubles) there is no result, and the caller must use the library's
/// parser.
/// </remarks>
internal static class DecimalQuotient
{
    public const int MaxDecimals = 22;

    private static readonly (ulong High, ulong Low, int Exponent)[] Reciprocals = [.. Enumerable.Range(0, MaxDecimals + 1).Select(Reciprocal)];

    /// <param name="mantissa">Above 0.</param>
    /// <param name="decimals">Power of ten to divide by, 0 to <see cref="MaxDecimals"/>.</param>
    /// <param name="value">The nearest double.</param>
    public static bool TryRound(ulong mantissa, int decimals, out double value)
    {
        var (high, low, exponent) = Reciprocals[decimals];
        var zeros = BitOperations.LeadingZeroCount(mantissa);
        var top = Math.BigMul(mantissa << zeros, high, out var middle);
        var carried = Math.BigMul(mantissa << zeros, low, out _);
        middle += carried;
        if (middle < carried) top++;
        var shift = (top >> 63) == 0 ? 10 : 11;
        var rounded = (top >> shift) + ((top >> (shift - 1)) & 1);
        value = rounded * BitConverter.UInt64BitsToDouble((ulong)(1023 + shift + 1 - zeros - exponent) << 52);
        return middle is not (0 or ulong.MaxValue);
    }

    /// <summary>2^(127 + exponent) / 10^decimals, truncated, with its highest bit set.</summary>
    private static (ulong High, ulong Low, int Exponent) Reciprocal(int decimals)
    {
        var power = BigInteger.Pow(10, decimals);
        var exponent = (int)(power - 1).GetBitLength();
        var quotient = (BigInteger.One << (127 + exponent)) / power;
        return ((ulong)(quotient >> 64), (ulong)(quotient & ulong.MaxValue), exponent);
    }
}
