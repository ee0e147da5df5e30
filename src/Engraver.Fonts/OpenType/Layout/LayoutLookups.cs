using System.Text;

namespace Engraver.Fonts.OpenType.Layout;

/// <summary>Finds the subtables of one kind that a feature of a layout table uses, in the order in which they apply.</summary>
public static class LayoutLookups
{
    private const int ExtensionType = 9;

    /// <summary>More than any font has; tables whose parts refer to each other in vast numbers end here.</summary>
    private const int MaxReferences = 1 << 16;

    /// <param name="table">GPOS.</param>
    /// <param name="feature">Four letters; features of that name are used for every script and language.</param>
    /// <exception cref="BrokenFontException">The table is invalid.</exception>
    public static IReadOnlyList<FontBytes> Subtables(FontBytes table, string feature, int type)
    {
        var lookups = table.Linked(8);
        var result = new List<FontBytes>();
        var references = 0;
        foreach (var index in LookupsOf(table.Linked(6), feature))
        {
            if (index >= lookups.UInt16(0))
                continue;
            var lookup = lookups.Linked(2 + 2 * index);
            for (var i = 0; i < lookup.UInt16(4); i++)
            {
                var subtable = lookup.Linked(6 + 2 * i);
                int actualType = lookup.UInt16(0);
                if (actualType == ExtensionType)
                {
                    actualType = subtable.UInt16(2);
                    subtable = subtable.Slice((int)subtable.UInt32(4));
                }
                if (++references > MaxReferences)
                    throw new BrokenFontException("A layout table of the font has too many parts.");
                if (actualType == type)
                    result.Add(subtable);
            }
        }
        return result;
    }

    private static SortedSet<int> LookupsOf(FontBytes features, string name)
    {
        var tag = new FontBytes(Encoding.ASCII.GetBytes(name)).UInt32(0);
        var indices = new SortedSet<int>();
        var references = 0;
        for (var i = 0; i < features.UInt16(0); i++)
        {
            if (features.UInt32(2 + 6 * i) != tag)
                continue;
            var feature = features.Linked(2 + 6 * i + 4);
            references += feature.UInt16(2);
            if (references > MaxReferences)
                throw new BrokenFontException("A layout table of the font has too many features.");
            for (var k = 0; k < feature.UInt16(2); k++)
                indices.Add(feature.UInt16(4 + 2 * k));
        }
        return indices;
    }
}
