using Avalonia.Media;
using Avalonia.Media.TextFormatting.Unicode;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Keeps what a simple text needs of each character of a face. Several threads may shape at once: each makes equal entries.</summary>
internal sealed class CharacterTable(GlyphTypeface typeface)
{
    private const int CharactersOfPage = 128;

    private readonly CharacterEntry[]?[] _pages = new CharacterEntry[]?[(char.MaxValue + 1) / CharactersOfPage];

    public CharacterEntry Of(Codepoint codepoint)
    {
        var value = (int)codepoint.Value;
        if (value > char.MaxValue)
            return Make(codepoint);
        var page = _pages[value / CharactersOfPage] ??= MakePage(value / CharactersOfPage);
        return page[value % CharactersOfPage];
    }

    private CharacterEntry[] MakePage(int index) =>
        [.. Enumerable.Range(index * CharactersOfPage, CharactersOfPage).Select(value => Make(new Codepoint((uint)value)))];

    private CharacterEntry Make(Codepoint codepoint)
    {
        var kind = KindOf(codepoint);
        var glyph = typeface.CharacterToGlyphMap[kind is CharacterKind.Tab or CharacterKind.Invisible ? ' ' : (int)codepoint.Value];
        return new CharacterEntry(glyph, typeface.TryGetHorizontalGlyphAdvance(glyph, out var advance) ? advance : (ushort)0, kind);
    }

    private static CharacterKind KindOf(Codepoint codepoint)
    {
        if (codepoint.Value == '\t')
            return CharacterKind.Tab;
        if (codepoint.IsBreakChar || codepoint.IsDefaultIgnorable)
            return CharacterKind.Invisible;
        return codepoint.GeneralCategory == GeneralCategory.NonspacingMark ? CharacterKind.Mark : CharacterKind.Letter;
    }
}

/// <param name="Glyph">That of a space for a tab and an invisible character.</param>
/// <param name="Advance">In font units.</param>
internal readonly record struct CharacterEntry(ushort Glyph, ushort Advance, CharacterKind Kind);

/// <summary>How a character of a simple text is shown.</summary>
internal enum CharacterKind : byte
{
    /// <summary>By its glyph.</summary>
    Letter,

    /// <summary>Over the letter before it, without an advance.</summary>
    Mark,

    /// <summary>Without a glyph and an advance.</summary>
    Invisible,

    Tab,
}
