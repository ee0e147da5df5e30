using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>A text that cannot be placed, or a letter that has no shape, is reported and never left out in silence.</summary>
public class FaultyTextTests
{
    [Theory]
    [InlineData(10, "NaN")]
    [InlineData(20, "1e300")]
    [InlineData(41, "abc")]
    [InlineData(50, "x")]
    public void A_text_with_an_unusable_number_is_not_cut_and_reported(int group, string value)
    {
        var lettered = Letter(DxfText.WithEntities((0, "TEXT"), (8, "0"), (group, value), (10, 1.0), (20, 1.0), (40, 5.0), (1, "A")));

        Assert.Empty(lettered.Letters.Texts);
        Assert.Equal(("TXT0015", group.ToString(System.Globalization.CultureInfo.InvariantCulture)), (Assert.Single(lettered.Findings).Id, lettered.Findings[0].Facts[1]));
        Assert.Equal(1, NotCut(lettered));
    }

    [Fact]
    public void A_text_in_a_block_without_height_is_not_cut_and_reported()
    {
        var drawing = new DxfText().Header("AC1015", 4)
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (0, "TEXT"), (8, "0"), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A"), (0, "ENDBLK"))
            .Section("ENTITIES", (0, "INSERT"), (8, "0"), (2, "B"), (10, 0.0), (20, 0.0), (42, 0.0)).End();

        var lettered = Letter(drawing);

        Assert.Empty(lettered.Letters.Texts);
        Assert.Contains(lettered.Findings, finding => finding.Id == "TXT0010");
        Assert.Empty(lettered.Letters.Faults);
    }

    [Fact]
    public void A_slant_above_85_degrees_is_reported()
    {
        var lettered = Letter(DxfText.WithEntities((0, "TEXT"), (8, "0"), (10, 1.0), (20, 1.0), (40, 5.0), (51, 89.0), (1, "A")));

        Assert.Contains(lettered.Findings, finding => finding.Id == "TXT0008" && finding.Facts[0].Contains("85", StringComparison.Ordinal));
    }

    [Fact]
    public void A_control_character_is_reported()
    {
        var lettered = Letter(DxfText.WithEntities((0, "TEXT"), (8, "0"), (10, 1.0), (20, 1.0), (40, 5.0), (1, "A\\U+0001B")));

        Assert.Contains(lettered.Findings, finding => finding.Id == "TXT0007" && finding.Facts[0].Contains("U+0001", StringComparison.Ordinal));
    }

    /// <summary>A font may name a character and have nothing for it.</summary>
    [Fact]
    public void A_letter_without_a_shape_takes_that_of_the_stroke_font_and_a_blank_stays_blank()
    {
        var (font, notes) = (new FoundFont(new HollowFont(), new FontRequest("", "", IsBold: false, IsItalic: false), FontMatch.Exact, FontTrouble.None, null, ""), new LayoutNotes());

        var run = LetterRun.Set("A A", font, LetterFormat.Upright(10.0), Point2D.Origin, notes);

        Assert.Equal([LetterFonts.BuiltIn, LetterFonts.BuiltIn], run.Glyphs.Select(glyph => glyph.Font));
        Assert.Equal([new LayoutNote(LayoutNoteKind.GlyphSubstituted, "A (U+0041)")], notes.All);
    }

    [Fact]
    public void A_trajectory_of_a_field_without_a_value_is_refused()
    {
        var drawing = Read(DxfText.WithEntities((0, "TEXT"), (8, "0"), (10, 1.0), (20, 1.0), (40, 5.0), (1, "A[[n]]")));

        var (trajectories, findings) = TrajectoryJob.Find(drawing, s_settings);

        Assert.Empty(trajectories);
        Assert.Contains(findings, finding => finding.Id == "SER0002");
    }

    private static readonly DrawingSettings s_settings = new() { Cut = CutChoice.Text };

    private static Drawing Read(DxfText drawing) => DxfReader.Read(drawing.ToAscii(), "test.dxf", DxfReadOptions.Default, CancellationToken.None);

    private static LetteredJob Letter(DxfText drawing) => JobPreparation.To<LetteredJob>(Read(drawing), s_settings);

    private static int NotCut(LetteredJob job) => Core.EntityTables.NotCutFindings.From(job.Drawing, StageOptions.SelectionOf(job.Settings)).Counts.Values.Sum();

    /// <summary>A font whose characters have a width and no lines.</summary>
    private sealed class HollowFont : ITextFont
    {
        public string Name => "hollow";

        public bool IsOutline => true;

        public FontMetrics Metrics => new(10.0, 10.0, 10.0, 2.0, 15.0);

        public bool Contains(int codePoint) => true;

        public GlyphCurves? GlyphOf(int codePoint) => new(6.0, []);

        public double KerningOf(int left, int right) => 0.0;
    }
}
