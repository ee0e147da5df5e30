using System.Buffers.Binary;
using Engraver.Fonts;
using Engraver.Fonts.OpenType;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Adds a map of format 12 to a font that has only the older formats 0 or 6: Avalonia reads formats 4, 12 and 13 (OpenType 1.9, cmap).</summary>
internal static class CharacterMapUpgrade
{
    private const int WindowsPlatform = 3;

    /// <returns>The table itself when it needs no change, or none is possible.</returns>
    public static ReadOnlyMemory<byte> Upgrade(ReadOnlyMemory<byte> table)
    {
        try
        {
            var maps = CharacterMap.ReadAll(new FontBytes(table)).Where(map => map.IsUnicode).ToList();
            return maps.Count > 0 && maps.All(map => map.Format is 0 or 6) ? Written(maps[0]) : table;
        }
        catch (BrokenFontException)
        {
            return table;
        }
    }

    /// <summary>One group of one character for each glyph.</summary>
    private static byte[] Written(CharacterMap old)
    {
        var pairs = Enumerable.Range(0, char.MaxValue + 1).Select(character => (Character: character, Glyph: old.GlyphOf(character))).Where(pair => pair.Glyph != 0).ToList();
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
}
