using Engraver.Fonts.Finding;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A font of the texts of a job, as records of the job state it.</summary>
/// <param name="Requested">As the drawing names it; "" where the drawing names none.</param>
/// <param name="Font">The name of the font that is cut.</param>
/// <param name="Match">exact, table (the substitution table names it), or substitute.</param>
/// <param name="Sha256">Of the bytes of the font's file or, for a font of the program, of its data; lower case.</param>
public sealed record CutFont(string Requested, string Font, string Match, string Sha256)
{
    /// <summary>The fonts of the texts, in the order of their first use; with the program's own font if it has the shape of a character that another one
    /// lacks.</summary>
    internal static IReadOnlyList<CutFont> Of(IReadOnlyList<LetteredText> texts, LetterFonts fonts) =>
        texts.Count == 0 ? [] : [.. fonts.Used.Concat(texts.SelectMany(text => text.Layout.Glyphs).Select(glyph => glyph.Font)).Select(From).Distinct()];

    /// <summary>The names of fonts that are not the same in two records.</summary>
    public static IReadOnlyList<string> Differences(IReadOnlyList<CutFont> one, IReadOnlyList<CutFont> other) =>
        [.. one.Except(other).Concat(other.Except(one)).Select(font => font.Requested.Length > 0 ? font.Requested : font.Font).Distinct()];

    private static CutFont From(FoundFont found) => new(
        LetteringFindings.NameOf(found.Request),
        found.Font.Name,
        found.Match switch { FontMatch.Exact => "exact", FontMatch.ByTable => "table", _ => "substitute" },
        found.Sha256);
}
