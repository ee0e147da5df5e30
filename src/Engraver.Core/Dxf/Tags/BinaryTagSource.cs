using System.Buffers.Binary;
using System.Globalization;

namespace Engraver.Core.Dxf.Tags;

/// <summary>The binary form: sentinel, then group code and value without separators. R12 writes codes as one byte (255 announces two more), later releases as
/// two.</summary>
internal sealed class BinaryTagSource : DxfTagSource
{
    private readonly bool _oneByteCodes;
    private int _valueStart;
    private int _valueLength;
    private BinaryValueType _type;

    public BinaryTagSource(IProgressiveBytes file)
        : base(file)
    {
        WaitForAll();
        Position = Sentinel.Length;
        _oneByteCodes = HasOneByteCodes(Rest);
    }

    /// <summary>The 22 bytes that open a binary DXF.</summary>
    public static ReadOnlySpan<byte> Sentinel => "AutoCAD Binary DXF\r\n\u001A\0"u8;

    /// <summary>True where the line end in the sentinel is not the original one.</summary>
    public static bool IsConverted(ReadOnlySpan<byte> file) => file.StartsWith(Sentinel[..^4]) && !file.StartsWith(Sentinel) && file.Length > Sentinel.Length && file[(Sentinel.Length - 4)..].TrimStart("\r\n"u8) is [0x1A, ..];

    public override bool IsBinary => true;

    private ReadOnlySpan<byte> Rest => Bytes[Position..];

    public override ReadOnlySpan<byte> Value => Bytes.Slice(_valueStart, _valueLength);

    public override bool TryNumber(out double number)
    {
        var value = Value;
        number = _type switch
        {
            BinaryValueType.Number => BinaryPrimitives.ReadDoubleLittleEndian(value),
            BinaryValueType.Byte => value[0],
            BinaryValueType.Short => BinaryPrimitives.ReadInt16LittleEndian(value),
            BinaryValueType.Integer => BinaryPrimitives.ReadInt32LittleEndian(value),
            BinaryValueType.Long => BinaryPrimitives.ReadInt64LittleEndian(value),
            _ => double.NaN,
        };
        return Math.Abs(number) <= DxfNumber.Largest;
    }

    protected override bool ReadPair()
    {
        var start = Position;
        if (start >= Bytes.Length) return false;
        if (!TakeCode(out var code)) return Stop();
        if (!BinaryValueTypes.TryOf(code, out _type))
        {
            // Without a known code the length of the value is also unknown: the data after it cannot be located.
            Damage(start, code.ToString(CultureInfo.InvariantCulture));
            return Stop();
        }

        Code = code;
        Line = start;
        return TakeValue() || Stop();
    }

    private static bool HasOneByteCodes(ReadOnlySpan<byte> rest) => rest.Length > 1 && (rest[0] == 0 ? rest[1] != 0 : rest[0] == 255);

    private bool Stop()
    {
        CutInsidePair = true;
        Position = Bytes.Length;
        return false;
    }

    private bool TakeCode(out int code)
    {
        var rest = Rest;
        code = rest[0];
        if (_oneByteCodes && code != 255)
        {
            Position++;
            return true;
        }

        var skip = _oneByteCodes ? 1 : 0;
        if (rest.Length < skip + 2) return false;
        code = BinaryPrimitives.ReadInt16LittleEndian(rest[skip..]);
        Position += skip + 2;
        return true;
    }

    private bool TakeValue()
    {
        var rest = Rest;
        var header = _type == BinaryValueType.Chunk ? 1 : 0;
        if (rest.Length < header) return false;
        var length = _type switch
        {
            BinaryValueType.Text => rest.IndexOf((byte)0),
            BinaryValueType.Chunk => rest[0],
            _ => BinaryValueTypes.SizeOf(_type),
        };
        if (length < 0 || header + length > rest.Length) return false;
        _valueStart = Position + header;
        _valueLength = length;
        Position = _valueStart + length + (_type == BinaryValueType.Text ? 1 : 0);
        return true;
    }
}
