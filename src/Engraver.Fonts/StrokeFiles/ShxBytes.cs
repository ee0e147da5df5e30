using System.Buffers.Binary;

namespace Engraver.Fonts.StrokeFiles;

/// <summary>Reads a part of an SHX file from its start to its end. Reading past the end is a <see cref="BrokenFontException"/>.</summary>
internal sealed class ShxBytes(ReadOnlyMemory<byte> data)
{
    private int _at;

    public byte Next() => Take(1).Span[0];

    public sbyte NextSigned() => (sbyte)Next();

    /// <summary>Numbers of the file have the least significant byte first.</summary>
    public int NextUInt16() => BinaryPrimitives.ReadUInt16LittleEndian(Take(2).Span);

    /// <summary>Numbers of subshapes have the most significant byte first.</summary>
    public int NextUInt16BigEndian() => BinaryPrimitives.ReadUInt16BigEndian(Take(2).Span);

    public ReadOnlyMemory<byte> Take(int length)
    {
        if (length > data.Length - _at) throw new BrokenFontException("The SHX file ends in the middle.");
        _at += length;
        return data.Slice(_at - length, length);
    }

    /// <summary>The bytes before the next one of this value, which is passed too.</summary>
    /// <exception cref="BrokenFontException">None of the next <paramref name="limit"/> bytes has the value.</exception>
    public ReadOnlyMemory<byte> TakeUntil(byte value, int limit)
    {
        var length = data.Span[_at..].IndexOf(value);
        if (length < 0 || length > limit) throw new BrokenFontException("A text of the SHX file has no end.");
        var text = Take(length);
        Take(1);
        return text;
    }
}
