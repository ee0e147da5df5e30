using Avalonia;
using Engraver.Fonts;
using Engraver.Fonts.OpenType;
using Engraver.Fonts.OpenType.Layout;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Positions of accents over or under their letters: GPOS mark-to-base attachment (OpenType 1.9, GPOS, lookup type 4).</summary>
internal sealed class MarkPlacement
{
    private const int MarkToBase = 4;

    private readonly IReadOnlyList<FontBytes> _subtables;

    private MarkPlacement(IReadOnlyList<FontBytes> subtables) => _subtables = subtables;

    public static MarkPlacement Read(FontFile file)
    {
        try
        {
            return new MarkPlacement(file.Has("GPOS") ? LayoutLookups.Subtables(file.Table("GPOS"), "mark", MarkToBase) : []);
        }
        catch (BrokenFontException)
        {
            return new MarkPlacement([]);
        }
    }

    /// <summary>Vector from the letter's origin to the mark's, in font units, y up. Null where the font has none.</summary>
    public Vector? Find(int letter, int mark)
    {
        try
        {
            foreach (var subtable in _subtables)
            {
                int markIndex = LayoutCoverage.Index(subtable.Linked(2), mark), letterIndex = LayoutCoverage.Index(subtable.Linked(4), letter);
                if (markIndex >= 0 && letterIndex >= 0 && Between(subtable, letterIndex, markIndex) is { } place)
                    return place;
            }
        }
        catch (BrokenFontException)
        {
            return null;
        }
        return null;
    }

    /// <summary>The vector that puts the mark's anchor on the letter's anchor for the mark's class.</summary>
    private static Vector? Between(FontBytes subtable, int letterIndex, int markIndex)
    {
        FontBytes marks = subtable.Linked(8), letters = subtable.Linked(10);
        int classes = subtable.UInt16(6), markClass = marks.UInt16(2 + 4 * markIndex);
        var anchor = 2 + 2 * (letterIndex * classes + markClass);
        if (letters.UInt16(anchor) == 0)
            return null;
        return Anchor(letters.Linked(anchor)) - Anchor(marks.Linked(2 + 4 * markIndex + 2));
    }

    private static Vector Anchor(FontBytes anchor) => new(anchor.Int16(2), anchor.Int16(4));
}
