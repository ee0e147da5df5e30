using Engraver.Fonts.Strokes;

namespace Engraver.Fonts.Tests.Strokes;

public class DoubleStrokeFontTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(30)]
    [InlineData(47.3)]
    [InlineData(70)]
    [InlineData(90)]
    [InlineData(140)]
    public void Every_contour_is_closed_and_everywhere_half_the_width_from_the_nearest_stroke(double width)
    {
        var font = new DoubleStrokeFont("D", StrokeFont.Engraver, width);
        var wrong = new List<string>();
        foreach (var code in StrokeFont.Engraver.CodePoints)
        {
            var strokes = StrokeGlyphs.Pieces(StrokeFont.Engraver.GlyphOf(code)!).ToList();
            var glyph = font.GlyphOf(code)!;
            if (glyph.Advance != StrokeFont.Engraver.GlyphOf(code)!.Advance) wrong.Add(StrokeGlyphs.Named(code) + " advance");
            if (glyph.Contours.Count == 0 != (strokes.Count == 0) || glyph.Contours.Any(contour => !contour.IsClosed)) wrong.Add(StrokeGlyphs.Named(code) + " open");
            var points = StrokeGlyphs.Pieces(glyph).SelectMany(piece => new[] { 0.1, 0.5, 0.9 }.Select(piece.PointAt));
            if (points.Any(point => Math.Abs(strokes.Min(stroke => stroke.DistanceTo(point)) - (width / 2)) > 0.08)) wrong.Add(StrokeGlyphs.Named(code) + " distance");
        }

        Assert.True(wrong.Count == 0, string.Join(", ", wrong));
    }

    [Fact]
    public void A_straight_stroke_becomes_two_lines_with_half_circles_at_the_ends()
    {
        var glyph = DoubleStrokeFont.Engraver.GlyphOf('I')!;

        Assert.Single(glyph.Contours);
        Assert.Equal((2 * 700) + (Math.PI * 70), StrokeGlyphs.Pieces(glyph).Sum(piece => piece.Length), 6);
    }

    [Fact]
    public void A_ring_becomes_two_rings_and_a_junction_is_open()
    {
        Assert.Equal(2, DoubleStrokeFont.Engraver.GlyphOf('O')!.Contours.Count);
        Assert.Single(DoubleStrokeFont.Engraver.GlyphOf('T')!.Contours);
        Assert.Equal(2, DoubleStrokeFont.Engraver.GlyphOf('A')!.Contours.Count);
        Assert.Equal(3, DoubleStrokeFont.Engraver.GlyphOf('8')!.Contours.Count);
    }

    [Fact]
    public void A_character_that_the_font_does_not_have_is_null() => Assert.Null(DoubleStrokeFont.Engraver.GlyphOf(0x4E00));

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void A_width_must_be_positive(double width) => Assert.Throws<ArgumentOutOfRangeException>(() => new DoubleStrokeFont("D", StrokeFont.Engraver, width));
}
