using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>Lowest and highest points of shapes, from the zeros of the derivatives of their curves.</summary>
internal static class LetterExtents
{
    public static (double Low, double High) Include((double Low, double High) box, LetterPlaces.Letter letter)
    {
        foreach (var contour in letter.Curves.Contours)
        {
            var from = contour.Start;
            foreach (var piece in contour.Pieces)
            {
                foreach (var height in Heights(from, piece).Select(height => letter.Rise + (letter.Scale * height))) box = (Math.Min(box.Low, height), Math.Max(box.High, height));
                from = piece.End;
            }
        }

        return box;
    }

    private static IEnumerable<double> Heights(FontPoint from, GlyphPiece piece) => piece.Kind switch
    {
        GlyphPieceKind.Arc when from != piece.End => [from.Y, piece.End.Y, .. Tops(new GlyphArc(from, piece))],
        GlyphPieceKind.Quadratic => Bezier(from.Y, from.Y + (2.0 / 3.0 * (piece.Control1.Y - from.Y)), piece.End.Y + (2.0 / 3.0 * (piece.Control1.Y - piece.End.Y)), piece.End.Y),
        GlyphPieceKind.Cubic => Bezier(from.Y, piece.Control1.Y, piece.Control2.Y, piece.End.Y),
        _ => from == piece.End ? [] : [from.Y, piece.End.Y],
    };

    private static IEnumerable<double> Tops(GlyphArc arc) => new[] { Math.PI / 2.0, -Math.PI / 2.0 }.Where(angle => arc.FractionOf(angle) <= 1.0).Select(angle => arc.Centre.Y + (arc.Radius * Math.Sin(angle)));

    private static IEnumerable<double> Bezier(double a, double b, double c, double d)
    {
        yield return a;
        yield return d;
        var (p, q, r) = (d - a + (3.0 * (b - c)), 2.0 * (a - (2.0 * b) + c), b - a);
        var root = (q * q) - (4.0 * p * r);
        if (root < 0.0) yield break;
        var half = -0.5 * (q + Math.CopySign(Math.Sqrt(root), q));
        foreach (var t in (double[])[half / p, r / half])
        {
            if (t is > 0.0 and < 1.0) yield return (((1.0 - t) * (1.0 - t) * (1.0 - t)) * a) + (3.0 * t * (1.0 - t) * (((1.0 - t) * b) + (t * c))) + (t * t * t * d);
        }
    }
}
