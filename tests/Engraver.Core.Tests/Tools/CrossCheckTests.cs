using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;
using Engraver.Tools.CrossChecks;

namespace Engraver.Core.Tests.Tools;

public class CrossCheckTests
{
    private static readonly byte[] Everything = OddDrawings.OneOfEverything().ToAscii();

    public static TheoryData<string> Samples => [.. Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Samples))]
    public void Both_readings_of_a_sample_agree(string name) => Assert.Empty(Differences(File.ReadAllBytes(Path.Combine(RepositoryFolder.Samples, name))));

    [Fact]
    public void Both_readings_of_everything_agree_in_every_form()
    {
        var everything = OddDrawings.OneOfEverything();
        foreach (var file in new[] { Everything, everything.ToAscii("\r\n"), everything.ToBinary(true), everything.ToBinary(false) }) Assert.Empty(Differences(file));
    }

    [Fact]
    public void Closed_and_tangent_splines_through_points_agree()
    {
        (int, object)[] points = [(11, 0), (21, 0), (11, 4), (21, 1), (11, 5), (21, 5), (11, -1), (21, 3)];

        Assert.Empty(Differences(DxfText.WithEntities([(0, "SPLINE"), (70, 1), (71, 3), .. points, (0, "SPLINE"), (70, 0), (71, 3), (12, 1), (22, 1), (13, 0), (23, -2), .. points]).ToAscii()));
    }

    [Fact]
    public void A_difference_in_each_figure_is_named()
    {
        var opinion = CrossCheck.Read(Everything);
        var other = DrawingSummary.From(DxfReading.Of(DxfText.WithEntities(OddDrawings.Arc)));

        var differences = opinion.DifferencesFrom(other);

        Assert.Contains(differences, text => text.StartsWith("ELLIPSE: 0 curves, the second reading has 1", StringComparison.Ordinal));
        Assert.Contains(differences, text => text.StartsWith("length: ", StringComparison.Ordinal));
        Assert.Single(differences, text => text.StartsWith("extents: ", StringComparison.Ordinal) && text.Split(" to ").Length == 3 && !text.Contains("Bounds2D", StringComparison.Ordinal));
    }

    /// <summary>For both readers, content outside of sections, or in the block that is model space, belongs to the drawing.</summary>
    [Fact]
    public void Both_readings_take_the_same_for_the_drawing()
    {
        (int, object)[] line = [(0, "LINE"), (8, "0"), (10, 0), (20, 0), (11, 3), (21, 4)];
        var loose = new DxfText().Add(line).Header("AC1015", 4).Section("ENTITIES", line).Add(line).Add((0, "ENDSEC")).End();
        var packed = new DxfText().Header("AC1015", 4).Section("BLOCKS", OddDrawings.Block("*Model_Space", line)).Section("ENTITIES", line).End();

        Assert.Empty(Differences(loose.ToAscii()));
        Assert.Empty(Differences(packed.ToAscii()));
        Assert.Equal((3, 2), (DxfReading.Of(loose).Entities.Count, DxfReading.Of(packed).Entities.Count));
    }

    /// <summary>UTF-16 of both orders, with and without a mark; an R12 binary whose first code needs three bytes.</summary>
    [Fact]
    public void Both_readings_know_wide_text_and_a_comment_that_opens_a_binary_file()
    {
        var text = System.Text.Encoding.ASCII.GetString(OddDrawings.OneOfEverything().ToAscii());
        foreach (var wide in (ReadOnlySpan<System.Text.Encoding>)[System.Text.Encoding.Unicode, System.Text.Encoding.BigEndianUnicode])
        {
            Assert.Empty(Differences(wide.GetBytes(text)));
            Assert.Empty(Differences(wide.GetBytes("\uFEFF" + text)));
        }

        Assert.Empty(Differences(new DxfText().Add((999, "made by hand")).Add([.. OddDrawings.OneOfEverything().Pairs]).ToBinary(oneByteCodes: true)));
    }

    /// <summary>The tip of the thinnest ellipse: two chord sums of different fineness that are too short by the same amount prove nothing.</summary>
    [Fact]
    public void Both_readings_measure_a_sharp_turn_alike() => Assert.Empty(Differences(DxfText.WithEntities(
        (0, "ELLIPSE"), (10, 0), (20, 0), (11, -16.446122721951824), (21, -16.702579524623026), (40, 1e-6), (41, 3.4845848090756792), (42, 1.296001523415514)).ToAscii()));

    [Fact]
    public void Both_readings_take_a_knot_that_was_rounded_down_for_the_one_before_it()
    {
        (int, object)[] knots = [.. new[] { 0, 0, 0, 0, 0.5, 0.49999999999, 1, 1, 1, 1 }.Select(knot => (40, (object)knot))];

        Assert.Empty(Differences(DxfText.WithEntities([(0, "SPLINE"), (71, 3), .. knots, (10, 0), (20, 0), (10, 0), (20, 9), (10, 3), (20, 3), (10, 3), (20, 0), (10, 4), (20, 0), (10, 5), (20, 5)]).ToAscii()));
    }

    [Fact]
    public void Both_readings_complete_knots_of_which_the_outer_two_are_missing()
    {
        (int, object)[] knots = [.. new[] { 0, 0, 0, 2, 5, 5, 5 }.Select(knot => (40, (object)knot))];

        Assert.Empty(Differences(DxfText.WithEntities([(0, "SPLINE"), (71, 3), .. knots, (10, 0), (20, 0), (10, 0), (20, 9), (10, 3), (20, 3), (10, 3), (20, 0), (10, 4), (20, 0)]).ToAscii()));
    }

    [Fact]
    public void What_the_reader_repairs_is_a_difference()
    {
        var file = DxfText.WithEntities((0, "LINE"), (10, "1,5"), (20, 0), (11, 3), (21, 0)).ToAscii();

        Assert.StartsWith("LINE: 1 curves, the second reading has 0", Differences(file)[0], StringComparison.Ordinal);
    }

    /// <summary>More curves than fit into memory twice, blocks of 20,000 levels, an array in an array, entities before the blocks.</summary>
    [Fact]
    public void Both_readings_of_large_and_deep_drawings_agree()
    {
        var chain = Enumerable.Range(1, 20_000).SelectMany(level => OddDrawings.Block($"L{level}", [(0, "INSERT"), (2, level == 1 ? "B" : $"L{level - 1}"), (10, 0.5), (20, 0), (70, level <= 2 ? 20 : 1), (71, level <= 2 ? 30 : 1), (44, 3), (45, 4)]));
        var file = new DxfText().Header("AC1015", 4)
            .Section("ENTITIES", [(0, "LINE"), (10, 0), (20, 0), (11, 1), (21, 0), .. OddDrawings.Insert("L20000", 1.0)])
            .Section("BLOCKS", [.. OddDrawings.Block("B", [(0, "LINE"), (10, 0), (20, 0), (11, 1), (21, 0)]), .. chain]).End().ToAscii();

        Assert.Equal(360_001, CrossCheck.Read(file).Counts["LINE"]);
        Assert.Empty(Differences(file));
    }

    [Theory]
    [InlineData("\n\r")]
    [InlineData("\n")]
    [InlineData("\r")]
    [InlineData("\r\n")]
    [InlineData("\r\r\n")]
    public void Both_readings_take_lines_to_end_alike(string lineEnd) => Assert.Empty(Differences(OddDrawings.OneOfEverything().ToAscii(lineEnd)));

    [Fact]
    public void A_bomb_is_left_to_the_reader()
    {
        var nest = new DxfText().Header("AC1015", 4).Section("BLOCKS", [.. OddDrawings.Block("B", OddDrawings.Circle)]).Section("ENTITIES", [.. OddDrawings.Insert("B", 1.0), (70, 32000), (71, 32000)]).End();

        Assert.Throws<CrossCheckException>(() => CrossCheck.Read(nest.ToAscii()));
        Assert.Throws<CrossCheckException>(() => CrossCheck.Read(new DxfText().Section("BLOCKS", [.. OddDrawings.Block("B", OddDrawings.Insert("B", 1.0))]).Section("ENTITIES", OddDrawings.Insert("B", 1.0)).End().ToAscii()));
    }

    private static IReadOnlyList<string> Differences(byte[] file) => CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(DxfReader.Read(file, "test.dxf", DxfReadOptions.Default, CancellationToken.None)));
}
