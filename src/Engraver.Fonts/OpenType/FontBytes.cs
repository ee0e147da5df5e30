using System.Buffers.Binary;

namespace Engraver.Fonts.OpenType;

/// <summary>Numbers in a piece of a font file, most significant byte first. Reading outside of the piece is a <see cref="BrokenFontException"/>.</summary>
public readonly record struct FontBytes(ReadOnlyMemory<byte> Memory)
{
    public int Length => Memory.Length;

    public byte Byte(int offset) => Span(offset, 1)[0];

    public ushort UInt16(int offset) => BinaryPrimitives.ReadUInt16BigEndian(Span(offset, 2));

    public short Int16(int offset) => BinaryPrimitives.ReadInt16BigEndian(Span(offset, 2));

    public uint UInt32(int offset) => BinaryPrimitives.ReadUInt32BigEndian(Span(offset, 4));

    public FontBytes Slice(int offset)
    {
        Check(offset, 0);
        return new FontBytes(Memory[offset..]);
    }

    public FontBytes Slice(int offset, int length)
    {
        Check(offset, length);
        return new FontBytes(Memory.Slice(offset, length));
    }

    /// <summary>The part at the offset given by the 16-bit number at <paramref name="offset"/>.</summary>
    public FontBytes Linked(int offset) => Slice(UInt16(offset));

    public ReadOnlySpan<byte> Span(int offset, int length)
    {
        Check(offset, length);
        return Memory.Span.Slice(offset, length);
    }

    private void Check(int offset, int length)
    {
        if (offset < 0 || length < 0 || offset > Memory.Length - length)
            throw new BrokenFontException("The font refers to a place outside of its table.");
    }
}
