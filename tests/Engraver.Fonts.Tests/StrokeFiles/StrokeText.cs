using System.Globalization;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Strokes as a text to compare: M start, L line, A arc with its bulge, Z if it is closed.</summary>
internal static class StrokeText
{
    public static string Of(GlyphCurves glyph) => string.Join(' ', glyph.Contours.Select(Of));

    private static string Of(GlyphContour contour) =>
        $"M{Of(contour.Start)} {string.Join(' ', contour.Pieces.Select(Of))}{(contour.IsClosed ? " Z" : "")}";

    private static string Of(GlyphPiece piece) => piece.Kind == GlyphPieceKind.Arc ? $"A{Of(piece.End)},{Number(piece.Bulge)}" : $"L{Of(piece.End)}";

    private static string Of(FontPoint point) => $"{Number(point.X)},{Number(point.Y)}";

    private static string Number(double value) => (Math.Round(value, 4) + 0.0).ToString(CultureInfo.InvariantCulture);
}
