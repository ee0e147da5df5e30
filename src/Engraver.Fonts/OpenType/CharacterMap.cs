namespace Engraver.Fonts.OpenType;

/// <summary>One of the lists of a font that lead from characters to glyphs (OpenType 1.9, cmap).</summary>
public sealed class CharacterMap
{
    private const int UnicodePlatform = 0;
    private const int MacintoshPlatform = 1;
    private const int WindowsPlatform = 3;
    private const int SymbolEncoding = 0;
    private const int FullUnicodeEncoding = 10;

    /// <summary>Where a symbol font has the characters 0 to 255.</summary>
    private const int SymbolPage = 0xF000;

    private readonly FontBytes _data;
    private readonly int _encoding;

    private CharacterMap(FontBytes data, int platform, int encoding)
    {
        _data = data;
        Platform = platform;
        _encoding = encoding;
        Format = data.UInt16(0);
    }

    public int Platform { get; }

    public int Format { get; }

    /// <summary>True if its characters are those of Unicode.</summary>
    public bool IsUnicode => Platform is UnicodePlatform or WindowsPlatform;

    private bool IsReadable => Format is 0 or 4 or 6 or 10 or 12 or 13;

    private bool IsSymbol => Platform == WindowsPlatform && _encoding == SymbolEncoding;

    /// <summary>Prefers the whole of Unicode, then its first plane, then symbols, then Macintosh Roman.</summary>
    private int Rank => (Platform, _encoding) switch
    {
        (WindowsPlatform, FullUnicodeEncoding) => 5,
        (UnicodePlatform, > 3) => 4,
        (WindowsPlatform, 1) => 3,
        (UnicodePlatform, _) => 2,
        (WindowsPlatform, SymbolEncoding) => 1,
        (MacintoshPlatform, 0) => 0,
        _ => -1,
    };

    /// <summary>All lists of the table, in its order.</summary>
    /// <param name="table">cmap.</param>
    /// <exception cref="BrokenFontException">The table is invalid.</exception>
    public static IReadOnlyList<CharacterMap> ReadAll(FontBytes table)
    {
        var maps = new List<CharacterMap>();
        for (var i = 0; i < table.UInt16(2); i++)
        {
            var record = 4 + 8 * i;
            maps.Add(new CharacterMap(table.Slice((int)table.UInt32(record + 4)), table.UInt16(record), table.UInt16(record + 2)));
        }
        return maps;
    }

    /// <summary>The list with most characters of Unicode.</summary>
    /// <exception cref="BrokenFontException">The table is invalid, or has no list that can be read.</exception>
    public static CharacterMap ReadBest(FontBytes table) =>
        ReadAll(table).Where(map => map.IsReadable && map.Rank >= 0).MaxBy(map => map.Rank)
        ?? throw new BrokenFontException("The font has no list of its characters that can be read.");

    /// <returns>0 if the font has no such character.</returns>
    /// <exception cref="BrokenFontException">The list is invalid.</exception>
    public int GlyphOf(int codePoint)
    {
        if (codePoint < 0 || (Platform == MacintoshPlatform && codePoint > 0x7F))
            return 0;
        var glyph = Find(codePoint);
        return glyph == 0 && IsSymbol && codePoint <= byte.MaxValue ? Find(SymbolPage + codePoint) : glyph;
    }

    private int Find(int code) => Format switch
    {
        0 => code <= byte.MaxValue ? _data.Byte(6 + code) : 0,
        4 => InSegments(code),
        6 => InArray(code, _data.UInt16(6), _data.UInt16(8), 10),
        10 => InArray(code, _data.UInt32(12), _data.UInt32(16), 20),
        12 => InGroups(code, isRange: true),
        13 => InGroups(code, isRange: false),
        _ => 0,
    };

    private int InArray(int code, uint first, uint count, int start) => code >= first && code - first < count ? _data.UInt16(start + 2 * (int)(code - first)) : 0;

    /// <summary>Segments are in the order of their last characters. The last segment is always the non-character 0xFFFF, in some fonts with an invalid
    /// offset.</summary>
    private int InSegments(int code)
    {
        if (code >= char.MaxValue)
            return 0;
        int twice = _data.UInt16(6) & ~1, low = 0, high = twice / 2;
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (_data.UInt16(14 + 2 * middle) < code)
                low = middle + 1;
            else
                high = middle;
        }
        if (low == twice / 2)
            return 0;
        int place = 16 + twice + 2 * low, first = _data.UInt16(place), delta = _data.UInt16(place + twice), offset = _data.UInt16(place + 2 * twice);
        if (code < first)
            return 0;
        if (offset == 0)
            return (code + delta) & 0xFFFF;
        int glyph = _data.UInt16(place + 2 * twice + offset + 2 * (code - first));
        return glyph == 0 ? 0 : (glyph + delta) & 0xFFFF;
    }

    /// <summary>Groups are in the order of their characters.</summary>
    private int InGroups(int code, bool isRange)
    {
        long low = 0, high = _data.UInt32(12) - 1L;
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var group = (int)Math.Min(16 + 12 * middle, int.MaxValue);
            if (code < _data.UInt32(group))
                high = middle - 1;
            else if (code > _data.UInt32(group + 4))
                low = middle + 1;
            else
                return (int)Math.Min(_data.UInt32(group + 8) + (isRange ? code - _data.UInt32(group) : 0L), char.MaxValue);
        }
        return 0;
    }
}
