using System.Globalization;
using System.Text;
using Engraver.Fonts.Strokes;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Strokes;

/// <summary>What the tests measure at glyphs of strokes.</summary>
internal static class StrokeGlyphs
{
    public static IEnumerable<int> Required() =>
        File.ReadLines(Path.Combine(RepositoryFolder.Root, "tests/Engraver.Fonts.Tests/Strokes/required.txt")).Where(line => line.Length > 0 && line[0] != '#').SelectMany(line =>
        {
            if (line[0] == '=') return line[2..].EnumerateRunes().Select(rune => rune.Value);
            var (first, last) = (Hex(line[..4]), Hex(line[5..]));
            return Enumerable.Range(first, last - first + 1);
        });

    public static string Named(int code) => $"U+{code:X4} {new Rune(code)}";

    public static IReadOnlyList<StrokePiece> Pieces(GlyphContour contour) => Stroke.Of(contour).Pieces;

    public static IEnumerable<StrokePiece> Pieces(GlyphCurves glyph) => glyph.Contours.SelectMany(Pieces);

    /// <summary>How many groups of contours that touch each other.</summary>
    public static int Parts(GlyphCurves glyph)
    {
        var groups = glyph.Contours.Select(contour => Pieces(contour).ToList()).ToList();
        for (var i = 0; i < groups.Count; i++)
        {
            for (var j = groups.Count - 1; j > i; j--)
            {
                if (!groups[i].Any(a => groups[j].Any(b => Touch(a, b)))) continue;
                groups[i].AddRange(groups[j]);
                groups.RemoveAt(j);
                j = groups.Count;
            }
        }

        return groups.Count;
    }

    private static bool Touch(StrokePiece a, StrokePiece b) =>
        new[] { b.Start, b.End }.Any(end => a.DistanceTo(end) < 0.01) || new[] { a.Start, a.End }.Any(end => b.DistanceTo(end) < 0.01)
        || StrokeCrossings.Of(a, b).Any(point => a.DistanceTo(point) < 0.01 && b.DistanceTo(point) < 0.01);

    private static int Hex(string text) => int.Parse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
}
