using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.Fonts.Finding;
using Engraver.TestKit;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Lettering.Paragraphs;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>The second calculation of the places of an MTEXT agrees with what is cut, and finds what is not at its place.</summary>
public class ParagraphPlacesTests
{
    private const string Mixed = "One {\\H2x;big} \\W0.5;narrow \\Q20;slanted \\T1.5;wide\\P\\Lunder\\l \\S1#2; and \\S+a^b;\\P\u00FC %%c";
    private const double MaxError = 0.0002;

    [Theory]
    [InlineData(0.0, 0.0, 0.0, 1.0, false)]
    [InlineData(33.0, 0.0, 0.0, 1.0, false)]
    [InlineData(33.0, 0.0, 0.0, -1.0, false)]
    [InlineData(0.0, 0.0, 0.0, 1.0, true)]
    [InlineData(10.0, 0.2, 0.3, 0.9, false)]
    [InlineData(10.0, 0.2, 0.3, 0.9, true)]
    public void It_agrees_in_every_position(double rotation, double nx, double ny, double nz, bool isInserted)
    {
        var text = TextOf(Mixed, (50, rotation), (210, nx), (220, ny), (230, nz));
        if (isInserted) text = text with { Inserts = Placement.FromInsert(new Vector3D(-2.0, 0.5, 1.0), Angle.FromDegrees(25.0)).MovedBy(new Vector3D(100.0, -50.0, 3.0)) };

        var (layout, curves) = Letter(text);

        Assert.True(layout.Glyphs.Count > 30, $"{layout.Glyphs.Count} glyphs");
        Assert.True(ParagraphPlaces.HasEveryLetter(text, layout));
        Assert.Null(LetterCheck.Find(ParagraphPlaces.Of(text, layout), curves, MaxError));
    }

    [Fact]
    public void A_stated_direction_goes_before_the_angle()
    {
        var text = TextOf("Ab", (50, 90.0), (11, 1.0), (21, 1.0), (31, 0.0));

        var (layout, curves) = Letter(text);

        Assert.Null(LetterCheck.Find(ParagraphPlaces.Of(text, layout), curves, MaxError));
        Assert.NotNull(LetterCheck.Find(ParagraphPlaces.Of(text with { Written = text.Written with { Paragraphs = text.Written.Paragraphs! with { XAxis = null } } }, layout), curves, MaxError));
    }

    [Fact]
    public void A_text_at_another_place_is_found()
    {
        var text = TextOf(Mixed);
        var (layout, curves) = Letter(text);

        Assert.NotNull(LetterCheck.Find(ParagraphPlaces.Of(text with { Written = text.Written with { Insertion = new Vector3D(1e-6, 0.0, 0.0) } }, layout), curves, MaxError));
    }

    [Fact]
    public void A_letter_that_is_missing_or_too_many_is_found()
    {
        var text = TextOf("Abc d");
        var layout = Letter(text).Layout;

        Assert.False(ParagraphPlaces.HasEveryLetter(text, layout with { Glyphs = [.. layout.Glyphs.Skip(1)] }));
        Assert.False(ParagraphPlaces.HasEveryLetter(text, layout with { Glyphs = [.. layout.Glyphs, layout.Glyphs[0]] }));
    }

    private static (TextLayout Layout, LetterCurves Curves) Letter(PlacedText text)
    {
        var layout = ParagraphLayout.Of(text, new LetterFonts([], new FontLibrary([], FontSubstitutes.Standard), []))!;
        return (layout, LetterCurves.Of(layout, MaxError));
    }

    private static PlacedText TextOf(string raw, params ReadOnlySpan<(int Code, object Value)> more) =>
        Assert.Single(DxfReader.Read(DxfText.WithEntities([(0, "MTEXT"), (8, "0"), (10, 0.0), (20, 0.0), (40, 2.5), (41, 30.0), (71, 5), (1, raw), .. more]).ToAscii(), "test.dxf", DxfReadOptions.Default, CancellationToken.None).Texts);
}
