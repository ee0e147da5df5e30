using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace Engraver.TestKit;

/// <summary>Writes a DXF as (group code, value) pairs: the same drawing as text or in either binary layout. Values are strings, whole numbers or
/// doubles.</summary>
public sealed class DxfText
{
    private readonly List<(int Code, object Value)> _pairs = [];

    public IReadOnlyList<(int Code, object Value)> Pairs => _pairs;

    /// <summary>A drawing in millimetres (so that the unit is not assumed) with these pairs as its ENTITIES.</summary>
    public static DxfText WithEntities(params ReadOnlySpan<(int Code, object Value)> entities) =>
        new DxfText().Header("AC1015", 4).Section("ENTITIES", entities).End();

    public DxfText Header(string version, int insUnits) =>
        Section("HEADER", (9, "$ACADVER"), (1, version), (9, "$INSUNITS"), (70, insUnits));

    public DxfText Section(string name, params ReadOnlySpan<(int Code, object Value)> pairs) =>
        Add((0, "SECTION"), (2, name)).Add(pairs).Add((0, "ENDSEC"));

    public DxfText End() => Add((0, "EOF"));

    public DxfText Add(params ReadOnlySpan<(int Code, object Value)> pairs)
    {
        _pairs.AddRange(pairs);
        return this;
    }

    /// <summary>The text form; every pair takes two lines, so pair n (from 0) starts at line 2n + 1.</summary>
    public byte[] ToAscii(string lineEnd = "\n")
    {
        var text = new StringBuilder();
        foreach (var (code, value) in _pairs)
        {
            text.Append(CultureInfo.InvariantCulture, $"{code,3}{lineEnd}");
            text.Append(value is double number ? number.ToString("R", CultureInfo.InvariantCulture) : Convert.ToString(value, CultureInfo.InvariantCulture)).Append(lineEnd);
        }

        return Encoding.UTF8.GetBytes(text.ToString());
    }

    /// <summary>The binary form: codes as one byte (R12; 255 is followed by two more) or as two (R13 and later).</summary>
    public byte[] ToBinary(bool oneByteCodes)
    {
        var bytes = new List<byte>("AutoCAD Binary DXF\r\n\u001A\0"u8.ToArray());
        foreach (var (code, value) in _pairs)
        {
            if (oneByteCodes && code < 255) bytes.Add((byte)code);
            else if (oneByteCodes) bytes.AddRange([255, (byte)code, (byte)(code >> 8)]);
            else bytes.AddRange([(byte)code, (byte)(code >> 8)]);
            bytes.AddRange(BinaryValue(code, value));
        }

        return [.. bytes];
    }

    private static byte[] BinaryValue(int code, object value)
    {
        var buffer = new byte[8];
        switch (code)
        {
            case (>= 10 and <= 59) or (>= 110 and <= 149) or (>= 210 and <= 239) or (>= 1010 and <= 1059):
                BinaryPrimitives.WriteDoubleLittleEndian(buffer, Convert.ToDouble(value, CultureInfo.InvariantCulture));
                return buffer;
            case (>= 60 and <= 79) or (>= 170 and <= 179) or (>= 270 and <= 289) or (>= 370 and <= 389) or (>= 1060 and <= 1070):
                BinaryPrimitives.WriteInt16LittleEndian(buffer, Convert.ToInt16(value, CultureInfo.InvariantCulture));
                return buffer[..2];
            case (>= 90 and <= 99) or (>= 420 and <= 429):
                BinaryPrimitives.WriteInt32LittleEndian(buffer, Convert.ToInt32(value, CultureInfo.InvariantCulture));
                return buffer[..4];
            case >= 290 and <= 299:
                return [Convert.ToByte(value, CultureInfo.InvariantCulture)];
            default:
                return [.. Encoding.UTF8.GetBytes((string)value), 0];
        }
    }
}
