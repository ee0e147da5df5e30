namespace Engraver.Core.Dxf.Tags;

/// <summary>The value types by range of group codes (DXF reference, "Group Code Value Types").</summary>
internal static class BinaryValueTypes
{
    private const int CodeCount = 1072;
    private const byte Unknown = byte.MaxValue;

    private static readonly byte[] Types = Build(
        (0, 9, BinaryValueType.Text), (10, 59, BinaryValueType.Number), (60, 79, BinaryValueType.Short), (90, 99, BinaryValueType.Integer),
        (100, 109, BinaryValueType.Text), (110, 149, BinaryValueType.Number), (160, 169, BinaryValueType.Long), (170, 179, BinaryValueType.Short),
        (210, 239, BinaryValueType.Number), (270, 289, BinaryValueType.Short), (290, 299, BinaryValueType.Byte), (300, 309, BinaryValueType.Text),
        (310, 319, BinaryValueType.Chunk), (320, 369, BinaryValueType.Text), (370, 389, BinaryValueType.Short), (390, 399, BinaryValueType.Text),
        (400, 409, BinaryValueType.Short), (410, 419, BinaryValueType.Text), (420, 429, BinaryValueType.Integer), (430, 439, BinaryValueType.Text),
        (440, 459, BinaryValueType.Integer), (460, 469, BinaryValueType.Number), (470, 481, BinaryValueType.Text), (999, 1003, BinaryValueType.Text),
        (1004, 1004, BinaryValueType.Chunk), (1005, 1009, BinaryValueType.Text), (1010, 1059, BinaryValueType.Number), (1060, 1070, BinaryValueType.Short),
        (1071, 1071, BinaryValueType.Integer));

    public static bool TryOf(int code, out BinaryValueType type)
    {
        var found = (uint)code < CodeCount ? Types[code] : Unknown;
        type = found == Unknown ? BinaryValueType.Text : (BinaryValueType)found;
        return found != Unknown;
    }

    /// <summary>Bytes of a value of fixed size.</summary>
    public static int SizeOf(BinaryValueType type) => type switch
    {
        BinaryValueType.Number or BinaryValueType.Long => 8,
        BinaryValueType.Integer => 4,
        BinaryValueType.Short => 2,
        BinaryValueType.Byte => 1,
        _ => throw new ArgumentOutOfRangeException(nameof(type), "Texts and chunks have no fixed size."),
    };

    private static byte[] Build(params ReadOnlySpan<(int First, int Last, BinaryValueType Type)> ranges)
    {
        var types = new byte[CodeCount];
        Array.Fill(types, Unknown);
        foreach (var (first, last, type) in ranges) Array.Fill(types, (byte)type, first, last - first + 1);
        return types;
    }
}

/// <summary>How a binary DXF stores the value of a group code.</summary>
internal enum BinaryValueType : byte
{
    /// <summary>Bytes up to a NUL.</summary>
    Text,

    /// <summary>Eight bytes, IEEE double.</summary>
    Number,

    Byte,

    Short,

    Integer,

    Long,

    /// <summary>A length byte, then that many bytes.</summary>
    Chunk,
}
