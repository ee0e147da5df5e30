using System.Text;

namespace Engraver.Fonts.OpenType;

/// <summary>The names of a face (OpenType 1.9, name).</summary>
/// <param name="Family">The family of all weights and widths.</param>
/// <param name="StyleFamily">The family of at most four styles (regular, bold, italic, bold italic), as Windows programs and drawings name it.</param>
/// <param name="Full">Family and style.</param>
public sealed record FontNames(string Family, string StyleFamily, string Full)
{
    private const int WindowsPlatform = 3;
    private const int MacintoshPlatform = 1;
    private const int English = 0x409;
    private const int FamilyId = 1;
    private const int FullId = 4;
    private const int TypographicFamilyId = 16;

    /// <param name="table">Name.</param>
    /// <exception cref="BrokenFontException">The table is invalid, or has no family.</exception>
    public static FontNames Read(FontBytes table)
    {
        var styleFamily = Find(table, FamilyId);
        var family = Find(table, TypographicFamilyId) ?? styleFamily ?? throw new BrokenFontException("The font has no name.");
        return new FontNames(family, styleFamily ?? family, Find(table, FullId) ?? family);
    }

    /// <summary>In English where the font has that.</summary>
    private static string? Find(FontBytes table, int id)
    {
        string? best = null;
        var bestRank = -1;
        for (var i = 0; i < table.UInt16(2); i++)
        {
            var record = table.Slice(6 + 12 * i, 12);
            var rank = Rank(record.UInt16(0), record.UInt16(4));
            if (record.UInt16(6) != id || rank <= bestRank)
                continue;
            var text = table.Linked(4).Span(record.UInt16(10), record.UInt16(8));
            best = record.UInt16(0) == MacintoshPlatform ? Encoding.Latin1.GetString(text) : Encoding.BigEndianUnicode.GetString(text);
            bestRank = rank;
        }
        return best;
    }

    private static int Rank(int platform, int language) => (platform, language) switch
    {
        (WindowsPlatform, English) => 3,
        (WindowsPlatform, _) => 2,
        (MacintoshPlatform, _) => 0,
        _ => 1,
    };
}
