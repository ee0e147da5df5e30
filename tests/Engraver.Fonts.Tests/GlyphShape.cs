namespace Engraver.Fonts.Tests;

/// <summary>Area and extent of the contours of a glyph, by formulas of the curves themselves.</summary>
internal static class GlyphShape
{
    /// <summary>Left, bottom, right, top of all points, control points included.</summary>
    public static (double Left, double Bottom, double Right, double Top) ControlBox(GlyphCurves glyph)
    {
        var points = glyph.Contours.SelectMany(contour => contour.Pieces.SelectMany(PointsOf).Prepend(contour.Start)).ToList();
        return (points.Min(p => p.X), points.Min(p => p.Y), points.Max(p => p.X), points.Max(p => p.Y));
    }

    /// <summary>Enclosed area, positive for contours drawn clockwise (TrueType), negative for those drawn counter-clockwise.</summary>
    public static double Area(GlyphCurves glyph) => -glyph.Contours.Sum(contour => AreaOf(contour));

    private static IEnumerable<FontPoint> PointsOf(GlyphPiece piece) => piece.Kind switch
    {
        GlyphPieceKind.Line => [piece.End],
        GlyphPieceKind.Quadratic => [piece.Control1, piece.End],
        _ => [piece.Control1, piece.Control2, piece.End],
    };

    /// <summary>Half the integral of x dy - y dx: exact for each degree.</summary>
    private static double AreaOf(GlyphContour contour)
    {
        var (at, sum) = (contour.Start, 0.0);
        foreach (var piece in contour.Pieces)
        {
            sum += piece.Kind switch
            {
                GlyphPieceKind.Line => Cross(at, piece.End) / 2,
                GlyphPieceKind.Quadratic => (2 * Cross(at, piece.Control1) + 2 * Cross(piece.Control1, piece.End) + Cross(at, piece.End)) / 6,
                _ => (6 * Cross(at, piece.Control1) + 3 * Cross(at, piece.Control2) + Cross(at, piece.End) + 3 * Cross(piece.Control1, piece.Control2)
                    + 3 * Cross(piece.Control1, piece.End) + 6 * Cross(piece.Control2, piece.End)) / 20,
            };
            at = piece.End;
        }
        return sum;
    }

    private static double Cross(FontPoint a, FontPoint b) => a.X * b.Y - a.Y * b.X;
}
