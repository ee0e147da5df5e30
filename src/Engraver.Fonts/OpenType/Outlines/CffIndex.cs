namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>A numbered list of pieces in a CFF table (Adobe TN 5176, section 5).</summary>
internal sealed class CffIndex
{
    private readonly FontBytes _data;
    private readonly int _offsetSize;

    private CffIndex(FontBytes data, int count, int offsetSize)
    {
        _data = data;
        Count = count;
        _offsetSize = offsetSize;
    }

    public static CffIndex Empty { get; } = new(default, 0, 0);

    public int Count { get; }

    public FontBytes this[int index]
    {
        get
        {
            if (index < 0 || index >= Count)
                throw new BrokenFontException("The font refers to a piece that it does not have.");
            var start = Offset(index);
            return _data.Slice(ObjectsStart + start, Offset(index + 1) - start);
        }
    }

    /// <summary>Offsets count from the byte before the first object.</summary>
    private int ObjectsStart => 3 + (Count + 1) * _offsetSize - 1;

    private int ByteLength => Count == 0 ? 2 : ObjectsStart + Offset(Count);

    /// <param name="offset">Where the list begins in the table; afterwards where it ended.</param>
    public static CffIndex Read(FontBytes table, ref int offset)
    {
        var data = table.Slice(offset);
        int count = data.UInt16(0);
        var index = new CffIndex(data, count, count == 0 ? 0 : data.Byte(2));
        if (count > 0 && (index._offsetSize is < 1 or > 4))
            throw new BrokenFontException("A list of the font has no valid offsets.");
        offset += index.ByteLength;
        return index;
    }

    private int Offset(int index)
    {
        var value = 0;
        foreach (var part in _data.Span(3 + index * _offsetSize, _offsetSize))
            value = value << 8 | part;
        return value;
    }
}
