using Engraver.Core.Drawings;
using Engraver.Core.TextMarkup;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.TextMarkup;

public class MTextParserTests
{
    private const int Many = 200_000;

    [Theory]
    [InlineData(@"one\Ptwo", "one|two")]
    [InlineData(@"one^Jtwo^M", "one|two")]
    [InlineData(@"a\~b \\ \{ \}", "a\u00A0b \\ { }")]
    [InlineData(@"%%c8 %%p0.1 %%065", "\u23008 \u00B10.1 A")]
    [InlineData(@"\U+00D8 \M+5B0A1", "\u00D8 \u554A")]
    [InlineData(@"{\fArial|b1|i0|c0|p34;bold} {\H2.5x;\C1;red}", "bold red")]
    [InlineData(@"\pxqc;centred\Pstill", "centred|still")]
    [InlineData(@"\H2without", "without")]
    [InlineData(@"x\Salone;y", "xaloney")]
    [InlineData("", "")]
    public void Characters_are_what_remains_without_codes(string raw, string characters)
    {
        var content = MTextParser.Parse(raw);

        Assert.Equal(characters, string.Join('|', content.Paragraphs.Select(paragraph => string.Concat(paragraph.Pieces.Select(piece => piece.Text)))));
        Assert.Empty(content.UnknownCodes);
    }

    [Fact]
    public void A_format_lasts_to_the_end_of_its_braces()
    {
        var pieces = Assert.Single(MTextParser.Parse(@"a{\H5;b{\H.5x;\W0.8;c}d}e").Paragraphs).Pieces;

        Assert.Equal(["a", "b", "c", "d", "e"], pieces.Select(piece => piece.Text));
        Assert.Equal([3.0, 5.0, 2.5, 5.0, 3.0], pieces.Select(piece => piece.Format.Height.Resolved(3.0)));
        Assert.Equal([1.1, 1.1, 0.8, 1.1, 1.1], pieces.Select(piece => piece.Format.Width.Resolved(1.1)));
    }

    [Fact]
    public void Each_format_code_changes_its_value()
    {
        var piece = Assert.Single(Assert.Single(MTextParser.Parse(@"\A1;\C3;\H2x;\H3x;\W1.5x;\Q-15;\T2;\T1.5x;\L\O\K\o\Ftxt.shx,big|c0;x").Paragraphs).Pieces);

        Assert.Equal((LineAlignment.Centre, 3, 12.0, 3.0), (piece.Format.Alignment, piece.Format.Colour!.Value.Index, piece.Format.Height.Resolved(2.0), piece.Format.Width.Resolved(2.0)));
        Assert.Equal((-15.0, 3.0, LineMarks.Underline | LineMarks.StrikeThrough), (piece.Format.Oblique!.Value.Degrees, piece.Format.Tracking, piece.Format.Marks));
        Assert.Equal(new MTextFont("txt.shx", "big", false, false, 0, 0, true), piece.Format.Font);
    }

    [Theory]
    [InlineData(@"\fArial|b1|i1|c238|p34;x", "Arial", true, true, 238, 34, false)]
    [InlineData(@"\fTimes New Roman;x", "Times New Roman", false, false, 0, 0, false)]
    [InlineData(@"\FArial|b0;x", "Arial", false, false, 0, 0, false)]
    [InlineData(@"\Fromans|c0;x", "romans", false, false, 0, 0, true)]
    public void A_font_is_a_family_or_a_file_of_strokes(string raw, string name, bool bold, bool italic, int set, int pitch, bool shape) =>
        Assert.Equal(new MTextFont(name, "", bold, italic, set, pitch, shape), MTextParser.Parse(raw).Paragraphs[0].Pieces[0].Format.Font);

    /// <summary>A true colour has its red in the low byte, unlike group 420.</summary>
    [Fact]
    public void Colours_are_an_index_or_blue_green_red()
    {
        var pieces = MTextParser.Parse(@"\C256;a\C0;b\c255;c\c16711680;d").Paragraphs[0].Pieces;

        Assert.Equal([DrawingColour.ByLayer, DrawingColour.ByBlock, DrawingColour.FromCode420(0xFF0000), DrawingColour.FromCode420(0x0000FF)], pieces.Select(piece => piece.Format.Colour!.Value));
    }

    [Theory]
    [InlineData(@"\S1/2;", "1", "2", MTextStackKind.Horizontal)]
    [InlineData(@"\S+0.1^ -0.2;", "+0.1", "-0.2", MTextStackKind.Tolerance)]
    [InlineData(@"\S3#4;", "3", "4", MTextStackKind.Diagonal)]
    [InlineData(@"\S2^ ;", "2", "", MTextStackKind.Tolerance)]
    [InlineData(@"\Sa\/b\;/%%c\U+00D8;", "a/b;", "\u2300\u00D8", MTextStackKind.Horizontal)]
    public void A_stack_has_two_texts(string raw, string upper, string lower, MTextStackKind kind)
    {
        var piece = Assert.Single(MTextParser.Parse(raw).Paragraphs[0].Pieces);

        Assert.Equal((MTextPieceKind.Stack, new MTextStack(upper, lower, kind)), (piece.Kind, piece.Stack));
    }

    [Fact]
    public void Tabs_and_breaks_are_pieces()
    {
        var pieces = MTextParser.Parse(@"a^Ib\Nc\Xd").Paragraphs[0].Pieces;

        Assert.Equal([MTextPieceKind.Text, MTextPieceKind.Tab, MTextPieceKind.Text, MTextPieceKind.ColumnBreak, MTextPieceKind.Text, MTextPieceKind.DimensionLineBreak, MTextPieceKind.Text], pieces.Select(piece => piece.Kind));
    }

    [Fact]
    public void A_paragraph_has_indents_tabs_and_alignment()
    {
        var paragraphs = MTextParser.Parse(@"\pxi-3.5,l4,r1,qj,sm1.5,b2,a0.5,t4,c12.5,r20;one\Ptwo\pi*,l*,q*,s*,t;\Pthree").Paragraphs;
        var first = paragraphs[0].Format;

        Assert.Equal((-3.5, 4.0, 1.0, 2.0, 0.5, ParagraphAlignment.Justified), (first.Indent, first.Left, first.Right, first.SpaceBefore, first.SpaceAfter, first.Alignment));
        Assert.Equal((ParagraphSpacing.Multiple, 1.5), (first.Spacing, first.SpacingValue));
        Assert.Equal([new(4.0, ParagraphAlignment.Left), new(12.5, ParagraphAlignment.Centre), new(20.0, ParagraphAlignment.Right)], first.Tabs);
        Assert.Equal((0.0, 0.0, 1.0, ParagraphAlignment.Default, ParagraphSpacing.Default, 0), (paragraphs[1].Format.Indent, paragraphs[1].Format.Left, paragraphs[1].Format.Right, paragraphs[1].Format.Alignment, paragraphs[1].Format.Spacing, paragraphs[1].Format.Tabs.Count));
        Assert.Equal(paragraphs[1].Format, paragraphs[2].Format);
    }

    [Theory]
    [InlineData(@"a\zb", @"a\zb", @"\z")]
    [InlineData(@"a}b", "ab", "}")]
    [InlineData(@"a{b", "ab", "{")]
    [InlineData(@"\Habc", "abc", @"\H")]
    [InlineData(@"\H0;a", "a", @"\H0;")]
    [InlineData(@"\H1e999;a", "a", @"\H1e999;")]
    [InlineData(@"\C300;a", "a", @"\C300;")]
    [InlineData(@"\A7;a", "a", @"\A7;")]
    [InlineData(@"\pq?;a", "a", @"\pq?;")]
    [InlineData(@"\f;a", "a", @"\f;")]
    [InlineData(@"\fArial", "Arial", @"\f")]
    [InlineData(@"\S1/2", "1/2", @"\S")]
    [InlineData(@"a\", @"a\", @"\")]
    [InlineData("a%%xb", "a%%xb", "%%x")]
    [InlineData("a^Ab", "ab", "^A")]
    [InlineData(@"a%<\AcVar Date>%b", "ab", @"%<\AcVar Date>%")]
    public void What_is_not_a_valid_code_is_reported(string raw, string characters, string unknown)
    {
        var content = MTextParser.Parse(raw);

        Assert.Equal(characters, string.Concat(content.Paragraphs[0].Pieces.Select(piece => piece.Text)));
        Assert.Equal([unknown], content.UnknownCodes);
    }

    [Property]
    public void Any_string_of_codes_is_read(int[]? choice)
    {
        string[] pieces = [@"\P", @"\H2;", @"\H.5x;", @"\S1/2;", @"\S", @"\fA|b1;", @"\f", @"\pi1,t2,c3;", @"\p", "{", "}", ";", "%%c", "%%u", @"%<\", ">%", @"\U+0041", "^I", "^J", @"\", "x", @"\C1;", "1e9", @"\T0.5x;", @"\\;", @"\;"];
        var raw = string.Concat((choice ?? []).Select(index => pieces[(int)((uint)index % (uint)pieces.Length)]));
        var content = MTextParser.Parse(raw);

        Assert.NotEmpty(content.Paragraphs);
        Assert.All(content.Paragraphs.SelectMany(paragraph => paragraph.Pieces), piece => Assert.Equal(piece.Kind == MTextPieceKind.Text, piece.Text.Length > 0));
        Assert.All(content.Paragraphs.SelectMany(paragraph => paragraph.Pieces), piece => Assert.True(double.IsFinite(piece.Format.Height.Resolved(1.0)) && piece.Format.Height.Resolved(1.0) > 0.0));
        Assert.True(content.Paragraphs.Sum(paragraph => paragraph.Pieces.Sum(piece => piece.Text.Length)) <= raw.Length);
    }

    [Property]
    public void Escaped_text_is_read_back(string? text)
    {
        var plain = string.Concat((text ?? "").Where(one => one >= ' ' && one is not ('%' or '^')));
        var raw = plain.Replace(@"\", @"\\", StringComparison.Ordinal).Replace("{", @"\{", StringComparison.Ordinal).Replace("}", @"\}", StringComparison.Ordinal);
        var content = MTextParser.Parse(raw);

        Assert.Empty(content.UnknownCodes);
        Assert.Equal(plain, string.Concat(Assert.Single(content.Paragraphs).Pieces.Select(piece => piece.Text)));
    }

    /// <summary>A method that is quadratic would take minutes for one of them.</summary>
    [Theory]
    [InlineData(@"\S\;")]
    [InlineData(@"\f\p")]
    [InlineData("{")]
    [InlineData("}")]
    [InlineData(@"{\H2x;a")]
    [InlineData(@"%<\")]
    [InlineData(@"\H1")]
    [InlineData(@"\La\l")]
    [InlineData(@"\P")]
    public void Long_strings_of_codes_are_read(string piece)
    {
        var content = MTextParser.Parse(string.Concat(Enumerable.Repeat(piece, Many)));

        Assert.True(content.UnknownCodes.Count <= 100);
        Assert.True(content.Paragraphs.Count <= Many + 1);
    }
}
