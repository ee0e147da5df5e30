using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Unions;
using Engraver.Fonts;
using Engraver.Fonts.OpenType;
using Engraver.TestKit;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>Glyphs of installed fonts, alone and overlapping, united and judged by <see cref="UnionWitness"/>.</summary>
public class InstalledOutlineTests
{
    private const double Error = 0.0005;

    /// <summary>Full run: every character of the fonts up to U+FFFF.</summary>
    private static readonly int Characters = TestExtent.Cases(perCommit: 40, full: 0x10000, "ENGRAVER_UNION_GLYPHS");

    private static readonly string[] s_paths =
    [
        InstalledFontFactAttribute.TrueType, "/usr/share/fonts/truetype/dejavu/DejaVuSerif-Bold.ttf", "/usr/share/fonts/truetype/tlwg/Garuda.ttf", "/usr/share/fonts/truetype/lohit-devanagari/Lohit-Devanagari.ttf",
        "/usr/share/fonts/opentype/urw-base35/Z003-MediumItalic.otf", "/usr/share/fonts/opentype/urw-base35/NimbusSans-Regular.otf",
    ];

    [InstalledFontFact]
    public void Every_glyph_is_united_exactly()
    {
        foreach (var (path, font) in Fonts())
        {
            foreach (var character in CharactersOf(font)) Judge($"{path} U+{character:X4}", Segments(font, character, Placement.Identity));
        }
    }

    /// <summary>Letters moved into each other by a third, with a turn, as narrow tracking does.</summary>
    [InstalledFontFact]
    public void Overlapping_letters_are_united_exactly()
    {
        foreach (var (path, font) in Fonts())
        {
            var characters = CharactersOf(font).ToArray();
            for (var first = 0; first + 6 <= characters.Length; first += 6)
            {
                var (word, x) = (new List<IReadOnlyList<Segment>>(), 0.0);
                for (var i = first; i < first + 6; i++)
                {
                    word.AddRange(Segments(font, characters[i], Placement.Identity).Select(contour => Moved(contour, x)));
                    x += 0.65 * font.GlyphOf(characters[i])!.Advance / font.Metrics.UnitsPerEm * 10.0;
                }

                Judge($"{path} U+{characters[first]:X4} and the next 5", word);
            }
        }
    }

    private static void Judge(string name, IReadOnlyList<IReadOnlyList<Segment>> contours)
    {
        if (contours.Count == 0) return;
        var fault = new UnionWitness(contours).Fault(ContourUnion.Unite(contours, 1e-6), 16);
        Assert.True(fault is null, $"{name}: {fault}");
    }

    private static IEnumerable<(string Path, OutlineFont Font)> Fonts() => s_paths.Where(File.Exists).Select(path => (path, new OutlineFont(new DiskFontSource(path))));

    private static IEnumerable<int> CharactersOf(OutlineFont font)
    {
        int[] all = [.. Enumerable.Range(0x21, 0xFFDE).Where(character => font.Contains(character) && font.GlyphOf(character) is { Contours.Count: > 0 })];
        var step = Math.Max(1, all.Length / Characters);
        return all.Where((_, i) => i % step == 0);
    }

    /// <summary>The contours of a glyph, 10 mm em.</summary>
    private static IReadOnlyList<Segment>[] Segments(OutlineFont font, int character, in Placement map)
    {
        var placed = map;
        var scale = Transform2D.ScaleFrom(Point2D.Origin, 10.0 / font.Metrics.UnitsPerEm);
        return [.. font.GlyphOf(character)!.Contours.Select(contour => LetterContour.Of(contour, placed)).Select(contour => BiarcFit.FitContour(contour.Parts.Select(part => contour.SegmentOf(part).Mapped(scale)), Error))];
    }

    private static IReadOnlyList<Segment> Moved(IReadOnlyList<Segment> contour, double x) => [.. contour.Select(segment => segment.Mapped(Transform2D.Move(new Vector2D(x, 0.0))))];
}
