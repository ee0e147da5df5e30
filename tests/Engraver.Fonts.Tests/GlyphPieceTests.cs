namespace Engraver.Fonts.Tests;

public class GlyphPieceTests
{
    private static readonly FontPoint s_end = new(3, 4);

    [Fact]
    public void Each_kind_keeps_its_points_and_no_others()
    {
        FontPoint first = new(1, 2), second = new(2, 5);

        Assert.Equal(new GlyphPiece(GlyphPieceKind.Line, default, default, s_end, 0), GlyphPiece.Line(s_end));
        Assert.Equal(new GlyphPiece(GlyphPieceKind.Arc, default, default, s_end, -0.5), GlyphPiece.Arc(s_end, -0.5));
        Assert.Equal(new GlyphPiece(GlyphPieceKind.Quadratic, first, default, s_end, 0), GlyphPiece.Quadratic(first, s_end));
        Assert.Equal(new GlyphPiece(GlyphPieceKind.Cubic, first, second, s_end, 0), GlyphPiece.Cubic(first, second, s_end));
    }
}
