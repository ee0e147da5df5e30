using Engraver.Fonts.Strokes;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Strokes;

public class StrokeFontReaderTests
{
    private const string Metrics = "metrics 1000 700 1000 250 1167\n";

    [Fact]
    public void A_shape_has_its_bearings_and_its_pieces()
    {
        var glyph = Read("I 80 70 : M 0 0 L 0 700 A 100 700 -180\n").GlyphOf('I')!;

        Assert.Equal(250, glyph.Advance);
        var contour = Assert.Single(glyph.Contours);
        Assert.Equal(new FontPoint(80, 0), contour.Start);
        Assert.Equal(GlyphPiece.Line(new FontPoint(80, 700)), contour.Pieces[0]);
        Assert.Equal((GlyphPieceKind.Arc, new FontPoint(180, 700)), (contour.Pieces[1].Kind, contour.Pieces[1].End));
        Assert.Equal(-1, contour.Pieces[1].Bulge, 12);
        Assert.False(contour.IsClosed);
    }

    [Fact]
    public void A_quarter_oval_is_two_arcs_that_are_tangent_to_each_other_and_to_the_axes()
    {
        var pieces = StrokeGlyphs.Pieces(Read("o 0 10 : M 200 700 h 0 350\n").GlyphOf('o')!).ToList();

        Assert.Equal(2, pieces.Count);
        Assert.Equal(0, Math.IEEERemainder(pieces[0].StartDirection - Math.PI, 2 * Math.PI), 9);
        Assert.Equal(0, Math.IEEERemainder(pieces[0].EndDirection - pieces[1].StartDirection, 2 * Math.PI), 9);
        Assert.Equal(0, Math.IEEERemainder(pieces[1].EndDirection + (Math.PI / 2), 2 * Math.PI), 9);
        Assert.Equal(new FontPoint(0, 350), pieces[1].End);
    }

    [Fact]
    public void Arcs_are_tangent_to_the_piece_before_or_after()
    {
        var pieces = StrokeGlyphs.Pieces(Read("o 0 10 : M 300 100 N 200 0 L 100 0 T 0 100\n").GlyphOf('o')!).ToList();

        Assert.Equal(-Math.PI / 2, pieces[0].Sweep, 9);
        Assert.Equal(Math.PI, Math.Abs(pieces[0].EndDirection), 9);
        Assert.Equal(-Math.PI / 2, pieces[2].Sweep, 9);
    }

    [Fact]
    public void A_mark_is_placed_on_the_anchor_of_the_shape_before_it()
    {
        var font = Read("a 50 50 : M 0 0 L 100 400 | under 20 -10\nmark U+0301 top : M 0 50 L 10 90 | top 0 100\nmark U+0323 under : M 0 0 L 0 -20\n", "ế = a U+0301 U+0301\nạ = a U+0323\ná = a U+0323@top\nа = a\n");

        Assert.Equal([new FontPoint(50, 0), new FontPoint(100, 450), new FontPoint(100, 550)], font.GlyphOf('ế')!.Contours.Select(contour => contour.Start));
        Assert.Equal(new FontPoint(70, -10), font.GlyphOf('ạ')!.Contours[1].Start);
        Assert.Equal(new FontPoint(100, 400), font.GlyphOf('á')!.Contours[1].Start);
        Assert.Equal(font.GlyphOf('a')!.Advance, font.GlyphOf('а')!.Advance);
        Assert.False(font.Contains(0x301));
    }

    [Fact]
    public void A_shape_of_a_later_line_is_scaled_and_moved() =>
        Assert.Equal([new FontPoint(10, 20), new FontPoint(60, 20)], Read("a 0 1 : U b 10 20 0.5\nb 0 1 : M 0 0 L 100 0 L 100 100\n").GlyphOf('a')!.Contours.SelectMany(contour => new[] { contour.Start, contour.Pieces[0].End }));

    [Theory]
    [InlineData("A 1 1 M 0 0 L 1 1", StrokeFault.Malformed)]
    [InlineData("A 1 : M 0 0 L 1 1", StrokeFault.Malformed)]
    [InlineData("A 1 1 : M 0 0 L 1", StrokeFault.Malformed)]
    [InlineData("A 1 1 : M 0 0 L 1 1 | top 1", StrokeFault.Malformed)]
    [InlineData("AB 1 1 : M 0 0 L 1 1", StrokeFault.NotACharacter)]
    [InlineData("U+110000 1 1 : M 0 0 L 1 1", StrokeFault.NotACharacter)]
    [InlineData("A 1 x : M 0 0 L 1 1", StrokeFault.NotANumber)]
    [InlineData("A 1 1 : M 0 0 L 1 NaN", StrokeFault.NotANumber)]
    [InlineData("A 1 1 : M 0 0 L 1 1e300", StrokeFault.NotANumber)]
    [InlineData("A 1 1 : M 0 0 Q 1 1", StrokeFault.UnknownCommand)]
    [InlineData("A 1 1 : L 1 1", StrokeFault.Misplaced)]
    [InlineData("A 1 1 : M 0 0", StrokeFault.Misplaced)]
    [InlineData("A 1 1 : M 0 0 T 1 1", StrokeFault.Misplaced)]
    [InlineData("A 1 1 : M 0 0 N 1 1", StrokeFault.Misplaced)]
    [InlineData("A 1 1 : M 0 0 Z", StrokeFault.Misplaced)]
    [InlineData("A 1 1 : M 0 0 L 0 0", StrokeFault.NoPiece)]
    [InlineData("A 1 1 : M 0 0 A 10 0 360", StrokeFault.NoPiece)]
    [InlineData("A 1 1 : M 0 0 h 10 0", StrokeFault.NoPiece)]
    [InlineData("A 1 1 : M 0 0 L 1 1\nA 1 1 : M 0 0 L 1 1", StrokeFault.Duplicate)]
    [InlineData("A 1 1 : U B 0 0", StrokeFault.NoSuchShape)]
    [InlineData("A 1 1 : U B 0 0\nB 1 1 : U A 0 0", StrokeFault.Circular)]
    [InlineData("A -5 1 : M 0 0 L 1 1", StrokeFault.NoAdvance)]
    [InlineData("metrics 1000 700 1000 250 1167", StrokeFault.Duplicate)]
    [InlineData("mark U+0301 top :", StrokeFault.Misplaced)]
    public void A_wrong_shape_is_reported_with_its_line(string shapes, StrokeFault fault)
    {
        var exception = Assert.Throws<StrokeFontException>(() => Read(shapes + "\n"));

        Assert.Equal((fault, "s.txt"), (exception.Fault, exception.File));
        Assert.InRange(exception.Line, 2, 3);
    }

    [Theory]
    [InlineData("Á = A", StrokeFault.NoSuchShape)]
    [InlineData("á = a U+0302", StrokeFault.NoSuchShape)]
    [InlineData("á = a a", StrokeFault.NoSuchShape)]
    [InlineData("á = U+0301", StrokeFault.NoSuchShape)]
    [InlineData("á = a U+0301@left", StrokeFault.NoSuchAnchor)]
    [InlineData("á a U+0301", StrokeFault.Malformed)]
    [InlineData("a = a", StrokeFault.Duplicate)]
    [InlineData("á = à\nà = á", StrokeFault.Circular)]
    public void A_wrong_composition_is_reported_with_its_line(string compositions, StrokeFault fault)
    {
        var exception = Assert.Throws<StrokeFontException>(() => Read("a 1 1 : M 0 0 L 1 1\nmark U+0301 top : M 0 0 L 1 1\n", compositions + "\n"));

        Assert.Equal((fault, "c.txt"), (exception.Fault, exception.File));
    }

    [Theory]
    [InlineData("")]
    [InlineData("metrics 1000 0 1000 250 1167")]
    public void Metrics_are_needed(string metrics) =>
        Assert.Equal(StrokeFault.NoMetrics, Assert.Throws<StrokeFontException>(() => StrokeFont.Read("F", "s.txt", new StringReader(metrics), "c.txt", new StringReader(""))).Fault);

    [Fact]
    public void Damaged_data_is_read_or_reported()
    {
        var folder = Path.Combine(RepositoryFolder.Root, "src/Engraver.Fonts/Strokes/Data");
        var (shapes, compositions) = (File.ReadAllText(Path.Combine(folder, "shapes.txt")), File.ReadAllText(Path.Combine(folder, "compositions.txt")));
        var random = new Random(35);
        var reported = 0;
        for (var i = 0; i < (TestExtent.IsFull ? 2000 : 60); i++)
        {
            try
            {
                StrokeFont.Read("F", "s.txt", new StringReader(Damaged(shapes, random)), "c.txt", new StringReader(Damaged(compositions, random)));
            }
            catch (StrokeFontException exception)
            {
                reported++;
                Assert.NotEmpty(exception.Message);
            }
        }

        Assert.True(reported > 20, $"{reported}");
    }

    private static string Damaged(string text, Random random)
    {
        var letters = text.ToCharArray();
        for (var i = 0; i < 4; i++) letters[random.Next(letters.Length)] = "MLATNhvZU|:= \n-0.9@+x"[random.Next(21)];
        return new string(letters);
    }

    private static StrokeFont Read(string shapes, string compositions = "") =>
        StrokeFont.Read("F", "s.txt", new StringReader(Metrics + shapes), "c.txt", new StringReader(compositions));
}
