using System.Buffers.Binary;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Adds a map of format 12 to a font that has only the older formats 0 or 6: Avalonia reads formats 4, 12 and 13 (OpenType 1.9, cmap).</summary>
internal static class CharacterMapUpgrade
{
    private const int UnicodePlatform = 0;
    private const int WindowsPlatform = 3;

    /// <returns>The table itself when it needs no change, or none is possible.</returns>
    public static ReadOnlyMemory<byte> Upgrade(ReadOnlyMemory<byte> table)
    {
        try
        {
            var subtables = Subtables(new FontBytes(table));
            if (subtables.Count == 0 || subtables.Any(map => map.UInt16(0) is not (0 or 6)))
                return table;
            return Written(subtables[0]);
        }
        catch (BrokenFontException)
        {
            return table;
        }
    }

    private static List<FontBytes> Subtables(FontBytes table)
    {
        var subtables = new List<FontBytes>();
        for (var i = 0; i < table.UInt16(2); i++)
        {
            if (table.UInt16(4 + 8 * i) is UnicodePlatform or WindowsPlatform)
                subtables.Add(table.Slice((int)table.UInt32(4 + 8 * i + 4)));
        }
        return subtables;
    }

    /// <summary>One group of one character for each glyph.</summary>
    private static byte[] Written(FontBytes old)
    {
        var pairs = Pairs(old).Where(pair => pair.Glyph != 0).ToList();
        var result = new byte[12 + 16 + 12 * pairs.Count];
        var target = result.AsSpan();
        BinaryPrimitives.WriteUInt16BigEndian(target[2..], 1);
        BinaryPrimitives.WriteUInt16BigEndian(target[4..], WindowsPlatform);
        BinaryPrimitives.WriteUInt16BigEndian(target[6..], 10);
        BinaryPrimitives.WriteUInt32BigEndian(target[8..], 12);
        BinaryPrimitives.WriteUInt16BigEndian(target[12..], 12);
        BinaryPrimitives.WriteInt32BigEndian(target[16..], 16 + 12 * pairs.Count);
        BinaryPrimitives.WriteInt32BigEndian(target[24..], pairs.Count);
        for (var i = 0; i < pairs.Count; i++)
        {
            var group = target[(28 + 12 * i)..];
            BinaryPrimitives.WriteInt32BigEndian(group, pairs[i].Character);
            BinaryPrimitives.WriteInt32BigEndian(group[4..], pairs[i].Character);
            BinaryPrimitives.WriteInt32BigEndian(group[8..], pairs[i].Glyph);
        }
        return result;
    }

    private static IEnumerable<(int Character, int Glyph)> Pairs(FontBytes old)
    {
        if (old.UInt16(0) == 0)
            return Enumerable.Range(0, 256).Select(character => (character, (int)old.Byte(6 + character)));
        int first = old.UInt16(6), count = old.UInt16(8);
        return Enumerable.Range(0, count).Select(i => (first + i, (int)old.UInt16(10 + 2 * i)));
    }
}
