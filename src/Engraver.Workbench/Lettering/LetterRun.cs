using System.Collections.Concurrent;
using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;
using Engraver.Shaping;

namespace Engraver.Workbench.Lettering;

/// <summary>Places the characters of one font and format side by side. The scale is the height of the text over the font's height of capital letters.</summary>
public static class LetterRun
{
    /// <summary>Of a text without a shape in any font: parts of the height of capital letters.</summary>
    private const double BoxWidth = 0.6;
    private const double BoxAdvance = 0.8;
    private const double BlankAdvance = 0.6;

    /// <summary>The sign of %%c, and the characters that fonts without it have for it: empty set (AutoCAD's), O with stroke.</summary>
    private const int Diameter = 0x2300;

    private static readonly int[] s_diameters = [0x2205, 0x00D8];

    /// <summary>The shapes that were read.</summary>
    private static readonly ConditionalWeakTable<ITextFont, ConcurrentDictionary<int, GlyphCurves?>> s_shapes = [];

    /// <summary>Slants beyond this are not in the range of the field (DXF reference, "TEXT", group 51).</summary>
    private const double LargestSlant = 85.0;

    /// <param name="text">UTF-16 without codes; composed here (normal form C). A tab is a blank.</param>
    /// <param name="origin">Of the first character, on the baseline.</param>
    /// <param name="notes">Receives the characters without a shape in the font.</param>
    public static LetterRunResult Set(string text, FoundFont font, LetterFormat format, Point2D origin, LayoutNotes notes)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(font);
        ArgumentNullException.ThrowIfNull(notes);
        if (Math.Abs(SignedSlant(format.Oblique)) > LargestSlant) notes.Add(LayoutNoteKind.FormIgnored, Wording.Get("LetterRun.Slant", LargestSlant));
        if (ShapedOf(text, font, format, origin, notes) is { } shaped) return shaped;
        var (glyphs, x, left) = (new List<GlyphPlace>(), origin.X, default(int?));
        foreach (var (from, codePoint, curves) in ShapesOf(text, font, notes))
        {
            var scale = format.Height / from.Font.Metrics.CapHeight;
            if (left is { } before && ReferenceEquals(from, font)) x += KerningOf(font.Font, before, codePoint) * scale * format.WidthFactor;
            left = ReferenceEquals(from, font) ? codePoint : null;
            if (curves.Contours.Count > 0) glyphs.Add(new GlyphPlace(from, codePoint, curves, MapOf(format, scale, x, origin.Y)));
            x += curves.Advance * scale * format.WidthFactor * format.Tracking;
        }

        return new LetterRunResult(glyphs, x - origin.X);
    }

    /// <summary>The glyphs of a text whose letters join or change places; null for any other text.</summary>
    internal static LetterRunResult? ShapedOf(string text, FoundFont font, LetterFormat format, Point2D origin, LayoutNotes notes) =>
        ShapedRun.TrySet(text, font, format, origin, notes, codePoint => GlyphOf(codePoint, font, notes));

    /// <summary>The characters that a text shows, each with its shape: the font's, otherwise the stroke font's, otherwise a box.</summary>
    internal static IEnumerable<(FoundFont Font, int CodePoint, GlyphCurves Curves)> ShapesOf(string text, FoundFont font, LayoutNotes notes)
    {
        foreach (var rune in Composed(text).EnumerateRunes())
        {
            if (Rune.IsControl(rune) && rune.Value != '\t') notes.Add(LayoutNoteKind.UnknownCode, string.Create(CultureInfo.InvariantCulture, $"U+{rune.Value:X4}"));
            if (IsWithoutShape(rune)) continue;
            if (ComplexLine.IsComplex(rune)) notes.Add(LayoutNoteKind.Unshaped, rune.ToString());
            yield return GlyphOf(rune.Value, font, notes);
        }
    }

    /// <summary>In font units; 0 for a pair that cannot be read.</summary>
    internal static double KerningOf(ITextFont font, int left, int right)
    {
        try
        {
            return font.KerningOf(left, right);
        }
        catch (BrokenFontException)
        {
            return 0.0; // its shapes are readable, only the pair is not: the plain advance
        }
    }

    /// <summary>The map of a point of the plane that is slanted with the letters of a run: for lines drawn with them.</summary>
    internal static double SlantAt(LetterFormat format, double above) => above * SlopeOf(format.Oblique);

    /// <summary>From font units to the plane, for a glyph whose origin is at a place.</summary>
    internal static Placement MapOf(LetterFormat format, double scale, double x, double y) => new(
        new Vector3D(scale * format.WidthFactor, 0.0, 0.0),
        new Vector3D(scale * SlopeOf(format.Oblique), scale, 0.0),
        new Vector3D(0.0, 0.0, scale),
        new Vector3D(x, y, 0.0));

    private static double SlopeOf(Angle oblique)
    {
        if (oblique == Angle.Zero) return 0.0;
        return Math.Tan(Angle.FromDegrees(Math.Clamp(SignedSlant(oblique), -LargestSlant, LargestSlant)).Radians);
    }

    /// <summary>Degrees from -180 to 180.</summary>
    private static double SignedSlant(Angle oblique) => Math.IEEERemainder(oblique.Degrees, 360.0);

    /// <summary>True for a character that a font shows as nothing: blanks, and the fillers of Hangul and Braille.</summary>
    internal static bool IsBlank(int codePoint) => Rune.IsWhiteSpace(new Rune(codePoint)) || codePoint is 0x115F or 0x1160 or 0x2800 or 0x3164 or 0xFFA0;

    /// <summary>True if the tool would follow something.</summary>
    internal static bool HasLines(GlyphCurves curves) => curves.Contours.Any(contour => contour.Pieces.Any(piece => piece.End != contour.Start || (piece.Kind is GlyphPieceKind.Quadratic or GlyphPieceKind.Cubic && piece.Control1 != contour.Start)));

    private static string Composed(string text)
    {
        try
        {
            return text.Normalize(NormalizationForm.FormC);
        }
        catch (ArgumentException)
        {
            return text; // half of a surrogate pair: its characters are looked up as they are
        }
    }

    private static (FoundFont Font, int CodePoint, GlyphCurves Curves) GlyphOf(int codePoint, FoundFont font, LayoutNotes notes)
    {
        if (Shape(codePoint, font.Font, notes) is { } own) return (font, codePoint, own);
        if (codePoint == Diameter)
        {
            foreach (var alike in s_diameters)
            {
                if (Shape(alike, font.Font, notes) is { } drawn) return (font, alike, drawn);
            }
        }

        if (IsBlank(codePoint)) return (font, codePoint, Shape(' ', font.Font, notes) ?? new GlyphCurves(BlankAdvance * font.Font.Metrics.CapHeight, []));
        var substitute = LetterFonts.BuiltIn;
        if (Shape(codePoint, substitute.Font, notes) is { } shape)
        {
            notes.Add(LayoutNoteKind.GlyphSubstituted, Name(codePoint));
            return (substitute, codePoint, shape);
        }

        notes.Add(LayoutNoteKind.GlyphMissing, Name(codePoint));
        return (substitute, 0, Box(substitute.Font.Metrics.CapHeight));
    }

    private static GlyphCurves? Shape(int codePoint, ITextFont font, LayoutNotes notes)
    {
        try
        {
            var curves = s_shapes.GetOrCreateValue(font).GetOrAdd(codePoint, font.GlyphOf);
            return curves is null || HasLines(curves) || IsBlank(codePoint) ? curves : null; // a letter without a shape is a missing one
        }
        catch (BrokenFontException)
        {
            notes.Add(LayoutNoteKind.GlyphBroken, Name(codePoint));
            return null;
        }
    }

    private static GlyphCurves Box(double height)
    {
        var width = BoxWidth * height;
        GlyphPiece[] sides = [GlyphPiece.Line(new FontPoint(width, 0.0)), GlyphPiece.Line(new FontPoint(width, height)), GlyphPiece.Line(new FontPoint(0.0, height)), GlyphPiece.Line(default)];
        return new GlyphCurves(BoxAdvance * height, [new GlyphContour(default, sides, IsClosed: true)]);
    }

    internal static string Name(int codePoint) => string.Create(CultureInfo.InvariantCulture, $"{new Rune(codePoint)} (U+{codePoint:X4})");

    /// <summary>Controls of layout, which no font draws: joiners, marks of direction, soft hyphens, variation selectors.</summary>
    private static bool IsWithoutShape(Rune rune) => Rune.GetUnicodeCategory(rune) is UnicodeCategory.Format or UnicodeCategory.Control ? rune.Value != '\t' : rune.Value is >= 0xFE00 and <= 0xFE0F;
}
