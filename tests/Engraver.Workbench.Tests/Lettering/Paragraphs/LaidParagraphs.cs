using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Lettering.Paragraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>Lays out MTEXTs of the program's stroke font, height 10, and computes places from its advances alone: a second way, without the layout.</summary>
internal static class LaidParagraphs
{
    public const double Height = 10.0;

    /// <summary>Samples of a curve when its box is measured.</summary>
    private const int Samples = 400;

    public static ITextFont Font => LetterFonts.BuiltIn.Font;

    private static double Scale => Height / Font.Metrics.CapHeight;

    public static PlacedText Text(string raw, WrittenParagraphs? paragraphs = null) => new()
    {
        Type = "MTEXT",
        Content = raw,
        Position = default,
        Height = Height,
        Rotation = default,
        Style = "plate",
        Font = "engraver",
        Layer = 0,
        Written = new WrittenText { Raw = raw, Height = Height, Paragraphs = paragraphs ?? new WrittenParagraphs() },
    };

    public static LetterFonts FontsWith(params TextStyle[] styles) => new([.. styles, new TextStyle("plate") { FontFile = "engraver" }], new FontLibrary([], FontSubstitutes.Standard), []);

    public static TextLayout Of(string raw, WrittenParagraphs? paragraphs = null) => Of(Text(raw, paragraphs));

    public static TextLayout Of(PlacedText text) => ParagraphLayout.Of(text, FontsWith()) ?? throw new InvalidOperationException("The text has no size.");

    /// <summary>The letters in reading order, a row for each baseline: blanks are not in it.</summary>
    public static IReadOnlyList<LaidRow> Rows(TextLayout layout)
    {
        var rows = new List<LaidRow>();
        foreach (var glyph in layout.Glyphs)
        {
            var (x, y) = (glyph.Map.Origin.X, glyph.Map.Origin.Y);
            var letter = new Rune(glyph.CodePoint).ToString();
            if (rows.Count > 0 && rows[^1].Y.Equals(y) && x > rows[^1].LastX) rows[^1] = rows[^1] with { Letters = rows[^1].Letters + letter, LastX = x };
            else rows.Add(new LaidRow(letter, x, y, x));
        }

        return rows;
    }

    public static string Letters(TextLayout layout) => string.Join('|', Rows(layout).Select(row => row.Letters));

    /// <summary>From the origin of the first letter to that of the one after the last, at height 10.</summary>
    public static double Advance(string text) => text.EnumerateRunes().Sum(rune => Font.GlyphOf(rune.Value)!.Advance) * Scale;

    /// <summary>From the origin of the first letter to the right side of the last one.</summary>
    public static double Inked(string text) => Advance(text[..^1]) + Box(text[^1]).Right;

    /// <summary>The box of a letter at height 10, from its origin.</summary>
    public static (double Left, double Bottom, double Right, double Top) Box(char letter) => BoxOf(Points(Font.GlyphOf(letter)!).Select(point => new Point2D(point.X * Scale, point.Y * Scale)));

    /// <summary>The box of all letters of a layout, in its plane.</summary>
    public static (double Left, double Bottom, double Right, double Top) Box(TextLayout layout) => BoxOf(layout.Glyphs.SelectMany(glyph => Points(glyph.Curves).Select(point =>
    {
        var at = glyph.Map.Apply(new Vector3D(point.X, point.Y, 0.0));
        return new Point2D(at.X, at.Y);
    })));

    private static (double Left, double Bottom, double Right, double Top) BoxOf(IEnumerable<Point2D> points)
    {
        var all = points.ToArray();
        return (all.Min(point => point.X), all.Min(point => point.Y), all.Max(point => point.X), all.Max(point => point.Y));
    }

    private static IEnumerable<FontPoint> Points(GlyphCurves curves)
    {
        foreach (var contour in curves.Contours)
        {
            var from = contour.Start;
            foreach (var piece in contour.Pieces)
            {
                for (var i = 0; i <= Samples; i++) yield return PointAt(from, piece, (double)i / Samples);
                from = piece.End;
            }
        }
    }

    private static FontPoint PointAt(FontPoint from, GlyphPiece piece, double t)
    {
        var r = 1.0 - t;
        return piece.Kind switch
        {
            GlyphPieceKind.Arc => ArcAt(from, piece, t),
            GlyphPieceKind.Quadratic => Sum((from, r * r), (piece.Control1, 2.0 * r * t), (piece.End, t * t)),
            GlyphPieceKind.Cubic => Sum((from, r * r * r), (piece.Control1, 3.0 * r * r * t), (piece.Control2, 3.0 * r * t * t), (piece.End, t * t * t)),
            _ => Sum((from, r), (piece.End, t)),
        };
    }

    private static FontPoint ArcAt(FontPoint from, GlyphPiece piece, double t)
    {
        var segment = ArcSegment.FromBulge(new Point2D(from.X, from.Y), new Point2D(piece.End.X, piece.End.Y), piece.Bulge);
        var angle = Math.Atan2(from.Y - segment.Centre.Y, from.X - segment.Centre.X) + (t * 4.0 * Math.Atan(piece.Bulge));
        return new FontPoint(segment.Centre.X + (segment.Radius * Math.Cos(angle)), segment.Centre.Y + (segment.Radius * Math.Sin(angle)));
    }

    private static FontPoint Sum(params (FontPoint Point, double Weight)[] parts) => new(parts.Sum(part => part.Point.X * part.Weight), parts.Sum(part => part.Point.Y * part.Weight));
}
