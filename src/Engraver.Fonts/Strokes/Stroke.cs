namespace Engraver.Fonts.Strokes;

/// <summary>Pieces that follow each other, each from the end of the one before; at least one.</summary>
internal sealed record Stroke(IReadOnlyList<StrokePiece> Pieces, bool IsClosed)
{
    public static Stroke Of(GlyphContour contour)
    {
        var at = contour.Start;
        var pieces = new List<StrokePiece>(contour.Pieces.Count);
        foreach (var piece in contour.Pieces)
        {
            pieces.Add(new StrokePiece(at, piece.End, piece.Bulge));
            at = piece.End;
        }

        return new Stroke(pieces, contour.IsClosed);
    }

    public Stroke Placed(double x, double y, double scale) => new([.. Pieces.Select(piece => piece.Placed(x, y, scale))], IsClosed);

    public GlyphContour ToContour() =>
        new(Pieces[0].Start, [.. Pieces.Select(piece => piece.IsLine ? GlyphPiece.Line(piece.End) : GlyphPiece.Arc(piece.End, piece.Bulge))], IsClosed);
}
