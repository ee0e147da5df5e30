namespace Engraver.Fonts;

/// <summary>A line or curve from the end of the piece before it. Values that its kind does not use are zero.</summary>
/// <param name="Control1">The control point of a quadratic curve, the first one of a cubic curve.</param>
/// <param name="Control2">The second control point of a cubic curve.</param>
/// <param name="Bulge">Of an arc, as in DXF: the tangent of a quarter of its sweep, positive counter-clockwise.</param>
public readonly record struct GlyphPiece(GlyphPieceKind Kind, FontPoint Control1, FontPoint Control2, FontPoint End, double Bulge)
{
    public static GlyphPiece Line(FontPoint end) => new(GlyphPieceKind.Line, default, default, end, 0);

    public static GlyphPiece Arc(FontPoint end, double bulge) => new(GlyphPieceKind.Arc, default, default, end, bulge);

    public static GlyphPiece Quadratic(FontPoint control, FontPoint end) => new(GlyphPieceKind.Quadratic, control, default, end, 0);

    public static GlyphPiece Cubic(FontPoint control1, FontPoint control2, FontPoint end) => new(GlyphPieceKind.Cubic, control1, control2, end, 0);
}
