using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.TestKit;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Lettering.Paragraphs;
using Engraver.Workbench.Tests.Machines;
using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>The format of letters, the plane of the text, and texts of every kind.</summary>
public class ParagraphLayoutTests
{
    private static double Scale => Height / Font.Metrics.CapHeight;

    [Fact]
    public void Height_width_and_slant_are_in_the_map_of_the_letters()
    {
        var glyphs = Of(@"H\H5;H\H2x;H\W0.5;H\Q45;H").Glyphs;
        Assert.Equal([1.0, 0.5, 1.0, 1.0, 1.0], glyphs.Select(glyph => glyph.Map.YAxis.Y / Scale), Near);
        Assert.Equal([1.0, 0.5, 1.0, 0.5, 0.5], glyphs.Select(glyph => glyph.Map.XAxis.X / Scale), Near);
        Assert.Equal([0.0, 0.0, 0.0, 0.0, 1.0], glyphs.Select(glyph => glyph.Map.YAxis.X / Scale), Near);
        Assert.Equal(Advance("H") * 3.0, glyphs[4].Map.Origin.X, 9);
    }

    [Fact]
    public void Tracking_is_a_multiple_of_the_advances() => Assert.Equal([0.0, 2.0 * Advance("H"), 4.0 * Advance("H")], Of(@"\T2;HHH").Glyphs.Select(glyph => glyph.Map.Origin.X), Near);

    [Fact]
    public void Width_factor_and_slant_of_the_style_apply_and_its_height_where_none_is_stated()
    {
        var style = new TextStyle("tag") { FontFile = "engraver", WidthFactor = 0.5, Oblique = Angle.FromDegrees(45.0), FixedHeight = 20.0, Generation = TextGeneration.Backwards };
        var text = Text(@"H\W2;\Q0;H") with { Style = "TAG" };
        var glyphs = ParagraphLayout.Of(text, FontsWith(style))!.Glyphs;
        Assert.Equal([(0.5, 1.0), (2.0, 0.0)], glyphs.Select(glyph => (Math.Round(glyph.Map.XAxis.X / Scale, 9), Math.Round(glyph.Map.YAxis.X / Scale, 9))));
        var fixedHeight = ParagraphLayout.Of(text with { Written = text.Written with { Height = 0.0 } }, FontsWith(style))!.Glyphs;
        Assert.Equal(2.0 * Scale, fixedHeight[0].Map.YAxis.Y, 9);
        Assert.Null(ParagraphLayout.Of(text with { Written = text.Written with { Height = 0.0 } }, FontsWith(new TextStyle("tag"))));
        Assert.Null(ParagraphLayout.Of(text, FontsWith(style with { WidthFactor = 0.0 })));
    }

    [Fact]
    public void A_code_changes_the_font()
    {
        var glyphs = Of(@"H\Fengraver-double;H\fengraver-double.shx|b0|i0;H").Glyphs;
        Assert.Equal(["engraver", "engraver-double", "engraver-double.shx"], glyphs.Select(glyph => glyph.Font.Request.File));
        Assert.NotEqual(glyphs[0].Font.Font.Name, glyphs[1].Font.Font.Name);
    }

    [Fact]
    public void Unknown_codes_and_vertical_flow_are_noted()
    {
        Assert.Equal([new LayoutNote(LayoutNoteKind.UnknownCode, @"\z"), new LayoutNote(LayoutNoteKind.UnknownCode, @"%<\AcVar Date>%")], Of(@"a\zb\zc%<\AcVar Date>%").Notes);
        Assert.Equal(LayoutNoteKind.FormIgnored, Assert.Single(Of("H", new() { FlowDirection = 3 }).Notes).Kind);
        Assert.Empty(Of("H", new() { FlowDirection = 5 }).Notes);
        var vertical = ParagraphLayout.Of(Text("H", new() { FlowDirection = 5 }) with { Style = "v" }, FontsWith(new TextStyle("v") { FontFile = "engraver", IsVertical = true }))!;
        Assert.Equal(LayoutNoteKind.FormIgnored, Assert.Single(vertical.Notes).Kind);
    }

    [Theory]
    [InlineData(0, 0, 0, 30, null, "0.866 0.5 0|-0.5 0.866 0")]
    [InlineData(0, 0, 1, 0, "0 5 0", "0 1 0|-1 0 0")]
    [InlineData(0, 0, -1, 0, null, "-1 0 0|0 1 0")]
    [InlineData(0, 0, -1, 90, null, "0 1 0|1 0 0")]
    [InlineData(0, 0, -1, 0, "1 0 0", "1 0 0|0 -1 0")]
    [InlineData(0, -2, 0, 0, "1 0 0", "1 0 0|0 0 1")]
    [InlineData(0, 0, 1, 0, "3 0 4", "1 0 0|0 1 0")]
    [InlineData(0, 0, 1, 90, "0 0 4", "0 1 0|-1 0 0")]
    [InlineData(0, 0, 1, 90, "0 0 0", "0 1 0|-1 0 0")]
    public void Direction_rotation_and_extrusion_are_the_plane(double x, double y, double z, double turn, string? along, string axes)
    {
        var axis = along?.Split(' ').Select(number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray();
        var text = Text("H", new() { XAxis = axis is null ? null : new Vector3D(axis[0], axis[1], axis[2]) });
        var plane = Of(text with { Written = text.Written with { Extrusion = new(x, y, z), Rotation = Angle.FromDegrees(turn), Insertion = new(7.0, 8.0, 9.0) } }).Plane;
        Assert.Equal(axes, $"{Shown(plane.XAxis)}|{Shown(plane.YAxis)}");
        Assert.Equal(new Vector3D(7.0, 8.0, 9.0), plane.Origin);
    }

    [Fact]
    public void Inserts_mirror_and_scale_the_plane()
    {
        var text = Text("H");
        var inserts = Placement.FromInsert(new Vector3D(-2.0, 3.0, 1.0), Angle.FromDegrees(90.0)).MovedBy(new Vector3D(100.0, 0.0, 0.0));
        var plane = Of(text with { Written = text.Written with { Insertion = new(10.0, 0.0, 0.0) }, Inserts = inserts }).Plane;
        Assert.Equal((new Vector3D(0.0, -2.0, 0.0), new Vector3D(-3.0, 0.0, 0.0), new Vector3D(100.0, -20.0, 0.0)), (plane.XAxis, plane.YAxis, plane.Origin));
    }

    [Theory]
    [InlineData("")]
    [InlineData(@"\P\P")]
    [InlineData("   ")]
    [InlineData(@"^I\N\X")]
    [InlineData(@"\S^;")]
    public void A_text_without_letters_has_none(string raw)
    {
        for (var place = 0; place <= 10; place++) Assert.Empty(Of(raw, new() { Attachment = place, ReferenceWidth = 5.0 }).Glyphs);
    }

    /// <summary>Every character with a shape is a glyph, in every MTEXT of real drawings.</summary>
    [CorpusFact]
    public void No_letter_of_the_corpus_is_lost()
    {
        var count = 0;
        foreach (var text in CorpusTexts())
        {
            if (ParagraphLayout.Of(text, FontsWith()) is not { } layout) continue;
            Assert.Equal(CharactersOf(text.Written.Raw), layout.Glyphs.Count);
            AssertFinite(layout, text.Written.Raw);
            count++;
        }

        Assert.InRange(count, 500, int.MaxValue);
    }

    [Fact]
    public void Changed_texts_are_laid_out_or_noted()
    {
        string[] parts =
        [
            @"\P", @"\N", @"\X", @"\~", " ", "^I", "{", "}", ";", @"\S1/2;", @"\Sa#;", @"\S", @"\H2x;", @"\H0.1;", @"\H1e300;", @"\W3;", @"\T0.75;", @"\Q89.9;", @"\A1;", @"\A2;", @"\L", @"\O", @"\K", @"\l",
            @"\pi1,l-2,r3,qj;", @"\pqd;", @"\pqc,t3,c5,r9;", @"\psm0.1;", @"\pse2;", @"\pa1,b1;", @"\p*;", @"\fArial|b1;", @"\Ftxt;", "%%c", @"\U+D83D", "word", "H", "\u00C5", "\u4E2D", "-", @"\C1;", @"\\", @"%<\x>%",
        ];
        double[] lengths = [0.0, -1.0, 1e-12, 3.0, 40.0, 1e300, double.NaN, double.PositiveInfinity];
        var random = new Random(35);
        for (var round = 0; round < TestExtent.Cases(2_000, 100_000, "ENGRAVER_FUZZ_CASES"); round++)
        {
            var raw = string.Concat(Enumerable.Range(0, random.Next(30)).Select(_ => parts[random.Next(parts.Length)]));
            var written = new WrittenParagraphs
            {
                Attachment = random.Next(-1, 12),
                ReferenceWidth = Any(),
                DefinedHeight = Any(),
                LineSpacingFactor = Any(),
                LineSpacingStyle = random.Next(4),
                Columns = random.Next(2) == 0 ? null : new TextColumns { Type = random.Next(4), Count = random.Next(-2, 5), Gutter = Any(), Width = Any(), Heights = [Any(), Any()], IsFlowReversed = random.Next(2) == 0 },
            };
            Assert.Equal(CharactersOf(raw), Of(raw, written).Glyphs.Count);
        }

        double Any() => lengths[random.Next(lengths.Length)];
    }

    /// <summary>A time that grew with the square of the length would be minutes.</summary>
    [Theory]
    [InlineData("H ")]
    [InlineData("H")]
    [InlineData(@"H\P")]
    [InlineData(@"H\~")]
    [InlineData(@"H^I")]
    [InlineData(@"\pt1,2,3;H^I")]
    [InlineData(@"H\N")]
    [InlineData(@"\H1.0001x;H ")]
    [InlineData(@"\LH\lH ")]
    [InlineData(@"\S1/2; ")]
    [InlineData(@"\U+05D0 H ")]
    public void A_very_long_text_is_laid_out(string part)
    {
        var raw = @"\pqd;" + string.Concat(Enumerable.Repeat(part, 20_000));
        var glyphs = Of(raw, new() { ReferenceWidth = 1_000.0, Columns = new TextColumns { Type = 2, Width = 1_000.0, Gutter = 1.0 }, DefinedHeight = 5_000.0 }).Glyphs;
        Assert.Equal(CharactersOf(raw), glyphs.Count);
    }

    private static IEnumerable<PlacedText> CorpusTexts()
    {
        foreach (var path in Directory.EnumerateFiles(RepositoryFolder.Corpus!, "*.dxf", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            foreach (var text in DxfReader.Read(File.ReadAllBytes(path), path, new DxfReadOptions(), CancellationToken.None).Texts)
            {
                if (text.Written.Paragraphs is not null) yield return text;
            }
        }
    }

    /// <summary>The characters of a text that have a shape: without blanks and controls, composed.</summary>
    private static int CharactersOf(string raw) => MTextParser.Parse(raw).Paragraphs.SelectMany(paragraph => paragraph.Pieces)
        .SelectMany(piece => piece.Stack is { } stack ? [stack.Upper, stack.Lower] : piece.Text.Split(' ', '\u00A0'))
        .Sum(part => Composed(part).EnumerateRunes().Count(rune => !Rune.IsWhiteSpace(rune) && Rune.GetUnicodeCategory(rune) is not (UnicodeCategory.Format or UnicodeCategory.Control)));

    private static string Composed(string part)
    {
        try
        {
            return part.Normalize();
        }
        catch (ArgumentException)
        {
            return part;
        }
    }

    private static void AssertFinite(TextLayout layout, string raw)
    {
        Assert.All(layout.Glyphs, glyph => Assert.True(double.IsFinite(glyph.Map.Origin.X) && double.IsFinite(glyph.Map.Origin.Y) && double.IsFinite(glyph.Map.XAxis.X) && double.IsFinite(glyph.Map.YAxis.Y), raw));
        Assert.All(layout.Rules, rule => Assert.True(rule.From.IsFinite && rule.To.IsFinite, raw));
        Assert.True(double.IsFinite(layout.Plane.XAxis.Length + layout.Plane.YAxis.Length + layout.Plane.Origin.Length), raw);
    }

    private static string Shown(Vector3D vector) => string.Join(' ', new[] { vector.X, vector.Y, vector.Z }.Select(value => (Math.Round(value, 3) + 0.0).ToString(CultureInfo.InvariantCulture)));

    private static bool Near(double expected, double actual) => Math.Abs(expected - actual) < 1e-9;
}
