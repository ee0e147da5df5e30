namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>What is true for every glyph of strokes.</summary>
internal static class StrokeFontCheck
{
    private const int MaxPieces = 20_000;

    public static IEnumerable<string> Faults(GlyphCurves glyph)
    {
        if (!double.IsFinite(glyph.Advance)) yield return "advance";
        if (glyph.Contours.Sum(contour => contour.Pieces.Count) > MaxPieces) yield return "pieces";
        foreach (var contour in glyph.Contours)
        {
            if (contour.Pieces.Count == 0) yield return "empty stroke";
            else if (contour.IsClosed && contour.Pieces[^1].End != contour.Start) yield return "not closed";
            if (contour.Pieces.Prepend(GlyphPiece.Line(contour.Start)).Any(piece => !(Math.Abs(piece.End.X) <= 1e6 && Math.Abs(piece.End.Y) <= 1e6 && double.IsFinite(piece.Bulge)))) yield return "not finite";
            if (contour.Pieces.Any(piece => piece.Kind is not (GlyphPieceKind.Line or GlyphPieceKind.Arc))) yield return "kind";
            if (contour.Pieces.Zip(contour.Pieces.Prepend(GlyphPiece.Line(contour.Start)), (piece, before) => piece.End == before.End).Any(isSame => isSame)) yield return "no length";
        }
    }
}
