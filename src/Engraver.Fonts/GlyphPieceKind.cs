namespace Engraver.Fonts;

public enum GlyphPieceKind : byte
{
    Line,

    /// <summary>A circular arc.</summary>
    Arc,

    /// <summary>A quadratic Bézier curve.</summary>
    Quadratic,

    /// <summary>A cubic Bézier curve.</summary>
    Cubic,
}
