namespace Engraver.Core.Dxf;

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
