namespace Engraver.Fonts.OpenType.Layout;

/// <summary>Corrections of the distance of two neighbours in fonts without GPOS: ordered lists of pairs (OpenType 1.9, kern, format 0; the header also in
/// the form of Apple's fonts).</summary>
public sealed class KernTable
{
    private const int MaxLists = 64;

    private readonly List<PairList> _lists = [];

    private KernTable()
    {
    }

    /// <exception cref="BrokenFontException">The table is invalid.</exception>
    public static KernTable Read(FontFile file)
    {
        var result = new KernTable();
        if (!file.Has("kern"))
            return result;
        var table = file.Table("kern");
        if (table.UInt16(0) == 0)
            result.ReadWindows(table);
        else
            result.ReadApple(table);
        return result;
    }

    /// <summary>Font units to add to the advance of <paramref name="first"/>; the glyphs are given from left to right.</summary>
    public int Between(int first, int second)
    {
        var sum = 0;
        foreach (var list in _lists)
        {
            if (list.Find(first, second) is { } value)
                sum = list.Replaces ? value : sum + value;
        }
        return sum;
    }

    private void ReadWindows(FontBytes table)
    {
        const int Horizontal = 1, Kind = 0xFF07, Replaces = 8;
        var offset = 4;
        for (var i = CountOf(table.UInt16(2)); i > 0; i--)
        {
            int coverage = table.UInt16(offset + 4);
            if ((coverage & Kind) == Horizontal)
                Add(table.Slice(offset + 6), (coverage & Replaces) != 0);
            offset += table.UInt16(offset + 2);
        }
    }

    private void ReadApple(FontBytes table)
    {
        const int AnyDirectionOrKind = 0xE0FF;
        var offset = 8;
        for (var i = CountOf(table.UInt32(4)); i > 0; i--)
        {
            if ((table.UInt16(offset + 4) & AnyDirectionOrKind) == 0)
                Add(table.Slice(offset + 8), replaces: false);
            offset += (int)Math.Min(table.UInt32(offset), (uint)table.Length);
        }
    }

    private static uint CountOf(uint lists) => lists <= MaxLists ? lists : throw new BrokenFontException("The font has too many lists of pairs.");

    /// <summary>The number of pairs decides, because the length in the header is too small a number for long lists.</summary>
    private void Add(FontBytes list, bool replaces)
    {
        int pairs = list.UInt16(0);
        _lists.Add(new PairList(list.Slice(8, 6 * pairs), pairs, replaces));
    }

    private sealed record PairList(FontBytes Data, int Count, bool Replaces)
    {
        public int? Find(int first, int second)
        {
            var wanted = (uint)first << 16 | (uint)second;
            int low = 0, high = Count - 1;
            while (low <= high)
            {
                var middle = (low + high) / 2;
                var pair = Data.UInt32(6 * middle);
                if (pair == wanted)
                    return Data.Int16(6 * middle + 4);
                if (pair < wanted)
                    low = middle + 1;
                else
                    high = middle - 1;
            }
            return null;
        }
    }
}
