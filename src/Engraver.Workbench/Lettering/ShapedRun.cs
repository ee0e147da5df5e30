using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;
using Engraver.Fonts.OpenType;
using Engraver.Shaping;

namespace Engraver.Workbench.Lettering;

/// <summary>Places the glyphs of an outline font for scripts whose letters join or change places, from left to right as they are seen.</summary>
internal static class ShapedRun
{
    private static readonly ConditionalWeakTable<OutlineFont, StrongBox<ShapingFace?>> s_faces = [];
    private static readonly ConditionalWeakTable<OutlineFont, ConcurrentDictionary<int, GlyphCurves>> s_glyphs = [];

    /// <returns>Null if the text needs no shaping, or the font cannot be shaped.</returns>
    /// <param name="substituteOf">The shape of a character that the font does not have.</param>
    public static LetterRunResult? TrySet(string text, FoundFont font, LetterFormat format, Point2D origin, LayoutNotes notes, Func<int, (FoundFont Font, int CodePoint, GlyphCurves Curves)> substituteOf)
    {
        if (font.Font is not OutlineFont outlines || !ComplexLine.IsComplex(text) || FaceOf(outlines) is not { } face) return null;
        var (glyphs, x) = (new List<GlyphPlace>(), origin.X);
        var line = ComplexLine.Shape(text.Replace('\t', ' '), face);
        foreach (var shaped in line)
        {
            var codePoint = Rune.TryGetRuneAt(text, shaped.Cluster, out var rune) ? rune.Value : 0;
            var curves = shaped.Glyph == 0 ? null : CurvesOf(outlines, shaped.Glyph, codePoint, notes);
            if (curves is not null && !LetterRun.HasLines(curves) && ComplexLine.IsComplex(rune) && Rune.IsLetter(rune) && line.Count(other => other.Cluster == shaped.Cluster) == 1) curves = null; // a letter without a shape
            if (curves is not null)
            {
                var scale = format.Height / font.Font.Metrics.CapHeight;
                var above = shaped.YOffset * scale;
                var place = new Point2D(x + (shaped.XOffset * scale * format.WidthFactor) + LetterRun.SlantAt(format, above), origin.Y + above);
                if (curves.Contours.Count > 0) glyphs.Add(new GlyphPlace(font, codePoint, curves, LetterRun.MapOf(format, scale, place.X, place.Y)));
                x += shaped.Advance * scale * format.WidthFactor * format.Tracking;
                continue;
            }

            var other = substituteOf(codePoint);
            var ratio = format.Height / other.Font.Font.Metrics.CapHeight;
            if (other.Curves.Contours.Count > 0) glyphs.Add(new GlyphPlace(other.Font, other.CodePoint, other.Curves, LetterRun.MapOf(format, ratio, x, origin.Y)));
            x += other.Curves.Advance * ratio * format.WidthFactor * format.Tracking;
        }

        return new LetterRunResult(glyphs, x - origin.X);
    }

    private static ShapingFace? FaceOf(OutlineFont font) => s_faces.GetValue(font, one => new StrongBox<ShapingFace?>(ShapingFace.TryCreate(one.TableOf, (int)one.Metrics.UnitsPerEm))).Value;

    /// <summary>Null for a glyph that cannot be read.</summary>
    private static GlyphCurves? CurvesOf(OutlineFont font, int glyph, int codePoint, LayoutNotes notes)
    {
        try
        {
            return s_glyphs.GetOrCreateValue(font).GetOrAdd(glyph, font.GlyphAt);
        }
        catch (BrokenFontException)
        {
            notes.Add(LayoutNoteKind.GlyphBroken, LetterRun.Name(codePoint));
            return null;
        }
    }
}
