using System.Text;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Each code of a shape, by coordinates that were calculated by hand.</summary>
public class ShxFontTests
{
    private const string Shapes10 = "shapes 1.0", Shapes11 = "shapes 1.1", Unifont = "unifont 1.0";

    public static TheoryData<string, byte[], string, double> Codes => new()
    {
        // Vectors: the longer part is the length, the other one is the same, half of it, or zero.
        { "right, up", [0x20, 0x34], "M0,0 L2,0 L2,3", 2 },
        { "each direction", [0x20, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26, 0x27], "M0,0 L2,0 L4,1 L6,3 L7,5 L7,7 L6,9 L4,11 L2,12", 2 },
        { "each other direction", [0x28, 0x29, 0x2A, 0x2B, 0x2C, 0x2D, 0x2E, 0x2F], "M0,0 L-2,0 L-4,-1 L-6,-3 L-7,-5 L-7,-7 L-6,-9 L-4,-11 L-2,-12", -2 },
        { "longest vector", [0xF0], "M0,0 L15,0", 15 },
        { "pen up and down", [0x10, 2, 0x10, 1, 0x10], "M0,0 L1,0 M2,0 L3,0", 3 },
        { "pen up without a move", [0x10, 2, 1, 0x10], "M0,0 L1,0 L2,0", 2 },
        { "divide", [3, 2, 0x30, 8, 1, 1], "M0,0 L1.5,0 L2,0.5", 2 },
        { "multiply", [4, 3, 0x10, 8, 2, 1], "M0,0 L3,0 L9,3", 9 },
        { "divide and multiply", [3, 4, 4, 2, 0x20, 4, 2, 0x20], "M0,0 L1,0 L3,0", 3 },
        { "push and pop", [5, 0x20, 6, 0x24], "M0,0 L2,0 M0,0 L0,2", 0 },
        { "nested positions", [5, 0x10, 5, 0x14, 6, 0x1C, 6, 0x14], "M0,0 L1,0 L1,1 M1,0 L1,-1 M0,0 L0,1", 0 },
        { "displacement", [8, 5, 0xFD], "M0,0 L5,-3", 5 },
        { "extreme displacement", [8, 127, 0x80], "M0,0 L127,-128", 127 },
        { "displacements", [9, 3, 1, 0xFE, 2, 0, 0, 0x10], "M0,0 L3,1 L1,3 L2,3", 2 },
        { "triangle", [9, 4, 0, 0xFE, 3, 0xFE, 0xFD, 0, 0, 2, 8, 6, 0], "M0,0 L4,0 L2,3 L0,0 Z", 6 },
        { "line forth and back", [8, 4, 0, 8, 0xFC, 0], "M0,0 L4,0 L0,0", 0 },
        // From 0 degrees, two octants: the centre is (-2, 0), the end is at 90 degrees. tan(90/4).
        { "quarter", [10, 2, 0x02], "M0,0 A-2,2,0.4142", -2 },
        // From octant 3 (135 degrees) clockwise to 45 degrees: the chord is the square root of 2.
        { "quarter clockwise", [10, 1, 0xB2], "M0,0 A1.4142,0,-0.4142", 1.4142 },
        { "half", [10, 3, 0x04], "M0,0 A-6,0,1", -6 },
        // Five octants are two arcs of 112.5 degrees: tan(112.5/4) = 0.5345.
        { "more than half", [10, 2, 0x05], "M0,0 A-2.7654,1.8478,0.5345 A-3.4142,-1.4142,0.5345", -3.4142 },
        { "circle", [10, 2, 0x40, 2, 0x40], "M0,0 A4,0,1 A0,0,1 Z", 4 },
        { "circle scaled", [3, 2, 10, 3, 0x00], "M0,0 A-3,0,1 A0,0,1 Z", 0 },
        // The example of the manual: 55 to 95 degrees, radius 3; the offsets round them to 54.84 and 94.92.
        { "fractional arc", [11, 56, 28, 0, 3, 0x12], "M0,0 A-1.9848,0.5362,0.1767", -1.9848 },
        { "fractional arc to an octant", [11, 0, 0, 0, 2, 0x02], "M0,0 A-2,2,0.4142", -2 },
        // From 67.5 to 90 degrees.
        { "fractional arc from half an octant", [11, 128, 0, 0, 10, 0x11], "M0,0 A-3.8268,0.7612,0.0985", -3.8268 },
        // From 90 - 22.5 to 0 + 22.5 degrees: 45 degrees clockwise in two octants.
        { "fractional arc clockwise", [11, 128, 128, 0, 10, 0xA2], "M0,0 A5.412,-5.412,-0.1989", 5.412 },
        { "fractional arc of a large radius", [11, 0, 0, 1, 4, 0x02], "M0,0 A-260,260,0.4142", -260 },
        { "bulge", [12, 4, 0, 127], "M0,0 A4,0,1", 4 },
        { "bulge clockwise", [12, 0, 4, 0x81], "M0,0 A0,4,-1", 0 },
        { "bulge of none", [12, 4, 2, 0], "M0,0 L4,2", 4 },
        { "bulges", [13, 0, 5, 127, 0, 5, 0, 3, 0, 0x81, 0, 0, 0x10], "M0,0 A0,5,1 L0,10 A3,10,-1 L4,10", 4 },
        { "ring of bulges", [13, 4, 0, 127, 0xFC, 0, 127, 0, 0], "M0,0 A4,0,1 A0,0,1 Z", 0 },
        { "vertical only", [14, 8, 9, 9, 14, 3, 0, 14, 9, 1, 1, 2, 2, 0, 0, 14, 10, 1, 2, 14, 11, 1, 2, 3, 4, 5, 14, 12, 1, 2, 3, 14, 13, 1, 1, 5, 2, 2, 6, 0, 0, 14, 2, 14, 5, 14, 0x55, 0x10], "M0,0 L1,0", 1 },
        { "vertical only twice", [14, 14, 3, 2, 0x10], "M0,0 L1,0", 1 },
        { "end after vertical only", [0x10, 14, 0, 0x10], "M0,0 L1,0", 1 },
        { "nothing drawn", [2, 0x50], "", 5 },
    };

    public static TheoryData<string, byte[]> BrokenCodes => new()
    {
        { "no end", [] },
        { "vector without an end", [0x10] },
        { "divide without a value", [3] },
        { "divide by zero", [3, 0, 0] },
        { "multiply by zero", [4, 0, 0] },
        { "position that was not saved", [6, 0] },
        { "too many positions", [5, 5, 5, 5, 5, 0] },
        { "missing subshape", [7, 0, 99, 0] },
        { "half a displacement", [8, 1] },
        { "displacements without an end", [9, 1, 1, 2, 2] },
        { "arc without a radius", [10, 0, 2, 0] },
        { "fractional arc without a radius", [11, 0, 0, 0, 0, 2, 0] },
        { "fractional arc that ends before it starts", [11, 200, 100, 0, 3, 0x11, 0] },
        { "half a fractional arc", [11, 1, 2, 3] },
        { "half a bulge", [12, 1, 1] },
        { "bulges without an end", [13, 1, 1, 1] },
        { "unknown code", [15, 0] },
        { "too large", [4, 255, 4, 255, 4, 255, 0xF0, 0] },
    };

    [Theory]
    [MemberData(nameof(Codes))]
    public void A_code_draws_what_the_manual_states(string what, byte[] codes, string strokes, double advance)
    {
        foreach (var kind in (string[])[Shapes10, Shapes11, Unifont])
        {
            var glyph = Font(new ShxBuilder(kind).With('A', codes)).GlyphOf('A')!;
            Assert.Equal((what, strokes), (what, StrokeText.Of(glyph)));
            Assert.Equal(advance, glyph.Advance, 4);
        }
    }

    [Theory]
    [MemberData(nameof(BrokenCodes))]
    public void Invalid_codes_break_the_glyph_and_not_the_font(string what, byte[] codes)
    {
        var font = Font(new ShxBuilder(Unifont).Named('A', "", codes).With('B', 0x10));

        Assert.True(font.Contains('A'), what);
        Assert.Throws<BrokenFontException>(() => font.GlyphOf('A'));
        Assert.Equal(1, font.GlyphOf('B')!.Advance);
    }

    [Fact]
    public void A_subshape_is_drawn_with_the_scale_and_pen_of_its_user()
    {
        var font = Font(new ShxBuilder(Shapes11).With('A', 0x10, 2, 0x14).With('B', 3, 2, 7, (byte)'A', 0x20, 1, 0x20));

        Assert.Equal("M0,0 L0.5,0 M1.5,0.5 L2.5,0.5", StrokeText.Of(font.GlyphOf('B')!));
    }

    [Fact]
    public void The_number_of_a_subshape_has_two_bytes_in_a_unifont()
    {
        var font = Font(new ShxBuilder(Unifont).With(0x0141, 0x10).With(0x4101, 0x24).With('B', 7, 0x01, 0x41));

        Assert.Equal("M0,0 L1,0", StrokeText.Of(font.GlyphOf('B')!));
    }

    [Fact]
    public void Shapes_that_contain_each_other_are_broken()
    {
        var font = Font(new ShxBuilder(Shapes10).With('A', 7, (byte)'B').With('B', 7, (byte)'A', 7, (byte)'A').With('C', 7, (byte)'C'));

        foreach (var letter in "ABC") Assert.Throws<BrokenFontException>(() => font.GlyphOf(letter));
    }

    [Fact]
    public void Shapes_that_multiply_are_stopped()
    {
        var font = new ShxBuilder(Shapes10).With('A', 0x10);
        for (var i = 'B'; i <= 'L'; i++) font.With(i, [.. Enumerable.Repeat((byte[])[7, (byte)(i - 1)], 20).SelectMany(code => code)]);

        Assert.Equal(400, Font(font).GlyphOf('C')!.Contours.Single().Pieces.Count);
        Assert.Throws<BrokenFontException>(() => Font(font).GlyphOf('L'));
    }

    [Theory]
    [InlineData(Shapes10)]
    [InlineData(Shapes11)]
    [InlineData(Unifont)]
    [InlineData("Shapes 1.0")]
    public void Heights_and_name_are_those_of_shape_zero(string kind)
    {
        var font = Font(new ShxBuilder(kind, above: 21, below: 7) { Name = "Roman" }.With(10, 2, 8, 0, 0xE0).With('A', 0x10));

        Assert.Equal(("Roman", false, new FontMetrics(28, 21, 21, 7, 32), 0.0), (font.Name, font.IsOutline, font.Metrics, font.KerningOf('A', 'A')));
    }

    [Fact]
    public void Without_a_line_feed_the_lines_have_the_spacing_of_AutoCAD() =>
        Assert.Equal((10.0, "file"), Font(new ShxBuilder(Unifont) { Name = "" }.With('A', 0x10)) is var font ? (font.Metrics.LineSpacing, font.Name) : default);

    [Fact]
    public void A_character_that_the_font_does_not_have_is_null()
    {
        var font = Font(new ShxBuilder(Unifont).With(10, 0x10).With('A', 0x10));

        foreach (var code in (int[])[0, 10, 'B', 0x4E00]) Assert.Equal((false, null), (font.Contains(code), font.GlyphOf(code)));
    }

    [Fact]
    public void Signs_of_fonts_that_are_not_Unicode_follow_the_letters()
    {
        var font = Font(new ShxBuilder(Shapes10).With(127, 0x10).With(128, 0x20).With(129, 0x30).With(0xE4, 0x40).With(0x85, 0x50));

        Assert.Equal([1, 2, 3, 3, 4], ((int[])[0xB0, 0xB1, 0x2300, 0x2205, 0xE4]).Select(code => font.GlyphOf(code)!.Advance));
        foreach (var code in (int[])[127, 128, 0x85, 0x100]) Assert.Null(font.GlyphOf(code));
    }

    [Fact]
    public void A_font_with_Latin_1_has_its_signs_there()
    {
        var font = new ShxBuilder(Shapes10).With(127, 0x10).With(128, 0x20).With(129, 0x30).With(0xB0, 0x40).With(0xB1, 0x50);
        double[] Advances() => [.. ((int[])[0xB0, 0xB1, 0x2300]).Select(code => Font(font).GlyphOf(code)!.Advance)];

        Assert.Equal([4, 5, 3], Advances());
        font.With(0xD8, 0x60);
        Assert.Equal([4, 5, 6], Advances());
    }

    [Theory]
    [InlineData(0x2205)]
    [InlineData(0x2300)]
    public void The_diameter_sign_of_a_unifont_may_have_either_code(int code)
    {
        var font = Font(new ShxBuilder(Unifont).With(code, 0x30));

        Assert.Equal([3, 3], ((int[])[0x2205, 0x2300]).Select(sign => font.GlyphOf(sign)!.Advance));
    }

    [Fact]
    public void Codes_that_are_not_Unicode_count_for_letters_of_ASCII_only()
    {
        var font = Font(new ShxBuilder(Unifont) { Definition = [6, 2, 0, 1, 0] }.With('A', 0x10).With(0x1234, 0x10));

        Assert.Equal((true, false), (font.Contains('A'), font.Contains(0x1234)));
    }

    [Fact]
    public void Bytes_after_the_last_shape_of_a_unifont_are_ignored() =>
        Assert.Equal(1, ShxFont.Read((byte[])[.. new ShxBuilder(Unifont).With('A', 0x10).Build(), .. "a mark"u8], "file").GlyphOf('A')!.Advance);

    [Theory]
    [InlineData("bigfont 1.0")]
    [InlineData("shapes 2.0")]
    [InlineData("")]
    public void Other_kinds_are_refused(string kind) => Refused(new ShxBuilder(kind).With('A', 0x10).Build());

    [Fact]
    public void What_is_not_a_text_font_is_refused()
    {
        Refused([]);
        Refused(Encoding.ASCII.GetBytes("AutoCAD-86 shapes 1.0\r\n"));
        Refused([.. "Another-86 shapes 1.0\r\n"u8, 0x1A, 0, 0, 0, 0, 0, 0]);
        Refused([.. "AutoCAD-86 shapes 1.0\r\n"u8, 0x1A, 1, 0, 1, 0, 1, 0, 1, 0, 3, 0, 0, 0x10, 0]);
        Refused(new ShxBuilder(Shapes10, above: 0).With('A', 0x10).Build());
    }

    [Fact]
    public void A_record_without_the_end_of_its_name_breaks_its_glyph_only()
    {
        var font = ShxFont.Read((byte[])[.. "AutoCAD-86 unifont 1.0\r\n"u8, 0x1A, 3, 0, 0, 0, 7, 0, 0, 6, 2, 0, 0, 0, 0, 65, 0, 2, 0, 1, 1, 66, 0, 3, 0, 0, 0x10, 0], "file");

        Assert.Throws<BrokenFontException>(() => font.GlyphOf('A'));
        Assert.Equal(1, font.GlyphOf('B')!.Advance);
    }

    [Fact]
    public void A_shape_that_the_file_has_twice_is_refused() =>
        Refused([.. "AutoCAD-86 unifont 1.0\r\n"u8, 0x1A, 3, 0, 0, 0, 7, 0, 0, 6, 2, 0, 0, 0, 0, 65, 0, 2, 0, 0, 0, 65, 0, 2, 0, 0, 0]);

    [Theory]
    [InlineData(Shapes10)]
    [InlineData(Unifont)]
    public void A_file_that_ends_early_is_refused(string kind)
    {
        var whole = new ShxBuilder(kind).With('A', 0x10, 0x24).Build();
        var used = kind == Unifont ? whole.Length : whole.Length - "EOF".Length;
        for (var length = 0; length < used; length++) Refused(whole[..length]);

        Assert.Equal(1, ShxFont.Read(whole.AsMemory(0, used), "file").GlyphOf('A')!.Advance);
    }

    private static ShxFont Font(ShxBuilder font) => ShxFont.Read(font.Build(), "file");

    private static void Refused(byte[] data) => Assert.Throws<BrokenFontException>(() => ShxFont.Read(data, "file"));
}
