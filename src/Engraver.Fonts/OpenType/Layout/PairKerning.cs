using System.Numerics;

namespace Engraver.Fonts.OpenType.Layout;

/// <summary>Corrections of the distance of two neighbours: GPOS pair adjustment, by glyphs and by classes (OpenType 1.9, GPOS, lookup type 2).</summary>
public sealed class PairKerning
{
    private const int PairAdjustment = 2;
    private const int XAdvance = 4;
    private const int XAndYPlacement = 3;

    private readonly IReadOnlyList<FontBytes> _subtables;

    private PairKerning(IReadOnlyList<FontBytes> subtables) => _subtables = subtables;

    /// <summary>Of a font without any.</summary>
    public static PairKerning None { get; } = new([]);

    /// <summary>True if the font has no pairs.</summary>
    public bool IsEmpty => _subtables.Count == 0;

    /// <exception cref="BrokenFontException">The table is invalid.</exception>
    public static PairKerning Read(FontFile file) =>
        file.Has("GPOS") ? new PairKerning(LayoutLookups.Subtables(file.Table("GPOS"), "kern", PairAdjustment)) : None;

    /// <summary>Font units to add to the advance of <paramref name="first"/>; the glyphs are given from left to right.</summary>
    /// <exception cref="BrokenFontException">The values of the pair are outside of the table.</exception>
    public int Between(int first, int second)
    {
        foreach (var subtable in _subtables)
        {
            var covered = LayoutCoverage.Index(subtable.Linked(2), first);
            if (covered < 0)
                continue;
            var found = subtable.UInt16(0) == 1 ? ByGlyph(subtable, covered, second) : ByClass(subtable, first, second);
            if (found is { } value)
                return value;
        }
        return 0;
    }

    /// <returns>Null when the next subtable must be searched.</returns>
    private static int? ByGlyph(FontBytes subtable, int covered, int second)
    {
        var set = subtable.Linked(10 + 2 * covered);
        var recordLength = 2 + RecordLength(subtable);
        int low = 0, high = set.UInt16(0) - 1;
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var record = 2 + middle * recordLength;
            int glyph = set.UInt16(record);
            if (glyph == second)
                return Advance(subtable, set, record + 2);
            if (glyph < second)
                low = middle + 1;
            else
                high = middle - 1;
        }
        return null;
    }

    /// <summary>A covered first glyph decides, even with a value of zero.</summary>
    private static int? ByClass(FontBytes subtable, int first, int second)
    {
        var firstClass = LayoutCoverage.Class(subtable.Linked(8), first);
        var secondClass = LayoutCoverage.Class(subtable.Linked(10), second);
        int firstCount = subtable.UInt16(12), secondCount = subtable.UInt16(14);
        if (firstClass >= firstCount || secondClass >= secondCount)
            return null;
        return Advance(subtable, subtable, 16 + (firstClass * secondCount + secondClass) * RecordLength(subtable));
    }

    private static int Advance(FontBytes subtable, FontBytes values, int record)
    {
        int format = subtable.UInt16(4);
        if ((format & XAdvance) == 0)
            return 0;
        return values.Int16(record + 2 * BitOperations.PopCount((uint)(format & XAndYPlacement)));
    }

    /// <summary>Size in bytes: two for each value that the formats of both glyphs name.</summary>
    private static int RecordLength(FontBytes subtable) =>
        2 * (BitOperations.PopCount(subtable.UInt16(4)) + BitOperations.PopCount(subtable.UInt16(6)));
}
