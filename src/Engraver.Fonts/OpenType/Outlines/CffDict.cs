using System.Globalization;
using System.Text;

namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Operators with their operands (Adobe TN 5176, section 4). Two-byte operators have 1200 added to their second byte.</summary>
internal sealed class CffDict
{
    public const int CharStrings = 17;
    public const int Private = 18;
    public const int Subroutines = 19;
    public const int FontArray = 1236;
    public const int FontSelect = 1237;

    private const int Escape = 12;
    private const int LastOperator = 21;
    private const int RealNumber = 30;

    private const int MaxLength = ushort.MaxValue;

    private readonly Dictionary<int, double[]> _entries = [];

    public CffDict(FontBytes data)
    {
        if (data.Length > MaxLength)
            throw new BrokenFontException("A dictionary of the font is too long.");
        var operands = new List<double>();
        for (var offset = 0; offset < data.Length;)
        {
            int first = data.Byte(offset);
            if (first > LastOperator)
            {
                operands.Add(Operand(data, ref offset));
                continue;
            }
            offset++;
            var key = first == Escape ? 1200 + data.Byte(offset++) : first;
            _entries[key] = [.. operands];
            operands.Clear();
        }
    }

    public bool Has(int key) => _entries.ContainsKey(key);

    /// <summary>An operand as a whole number; 0 where it is absent.</summary>
    public int Integer(int key, int operand = 0) =>
        _entries.TryGetValue(key, out var operands) && operand < operands.Length ? (int)operands[operand] : 0;

    private static double Operand(FontBytes data, ref int offset)
    {
        int first = data.Byte(offset);
        switch (first)
        {
            case 28:
                offset += 3;
                return data.Int16(offset - 2);
            case 29:
                offset += 5;
                return (int)data.UInt32(offset - 4);
            case RealNumber:
                offset++;
                return Real(data, ref offset);
            case >= 32 and <= 246:
                offset++;
                return first - 139;
            case >= 247 and <= 250:
                offset += 2;
                return (first - 247) * 256 + data.Byte(offset - 1) + 108;
            case >= 251 and <= 254:
                offset += 2;
                return -(first - 251) * 256 - data.Byte(offset - 1) - 108;
            default:
                throw new BrokenFontException("A dictionary of the font has an unknown operand.");
        }
    }

    /// <summary>Half bytes: digits, a point, exponents, a minus, and an end.</summary>
    private static double Real(FontBytes data, ref int offset)
    {
        var text = new StringBuilder();
        while (true)
        {
            int pair = data.Byte(offset++);
            foreach (var half in (ReadOnlySpan<int>)[pair >> 4, pair & 15])
            {
                if (half == 15)
                    return double.TryParse(text.ToString(), NumberStyles.Float, CultureInfo.InvariantCulture, out var value) ? value : 0;
                text.Append(half switch { < 10 => ((char)('0' + half)).ToString(), 10 => ".", 11 => "E", 12 => "E-", 14 => "-", _ => "" });
            }
        }
    }
}
