using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.SecondOpinions;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.SecondOpinions;

public class SecondOpinionTests
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
        var opinion = SecondOpinion.Of(Everything);
        var other = DrawingSummary.Of(Reading.Of(DxfText.WithEntities(OddDrawings.Arc)));

        var differences = opinion.DifferencesFrom(other);

        Assert.Contains(differences, text => text.StartsWith("ELLIPSE: 0 curves, the second reading has 1", StringComparison.Ordinal));
        Assert.Contains(differences, text => text.StartsWith("length: ", StringComparison.Ordinal));
        Assert.Contains(differences, text => text.StartsWith("extents: ", StringComparison.Ordinal));
    }

    [Fact]
    public void What_the_reader_repairs_is_a_difference()
    {
        var file = DxfText.WithEntities((0, "LINE"), (10, "1,5"), (20, 0), (11, 3), (21, 0)).ToAscii();

        Assert.StartsWith("LINE: 1 curves, the second reading has 0", Differences(file)[0], StringComparison.Ordinal);
    }

    [Fact]
    public void A_bomb_is_left_to_the_reader()
    {
        var nest = new DxfText().Header("AC1015", 4).Section("BLOCKS", [.. OddDrawings.Block("B", OddDrawings.Circle)]).Section("ENTITIES", [.. OddDrawings.Insert("B", 1.0), (70, 32000), (71, 32000)]).End();

        Assert.Throws<SecondOpinionException>(() => SecondOpinion.Of(nest.ToAscii()));
        Assert.Throws<SecondOpinionException>(() => SecondOpinion.Of(new DxfText().Section("BLOCKS", [.. OddDrawings.Block("B", OddDrawings.Insert("B", 1.0))]).Section("ENTITIES", OddDrawings.Insert("B", 1.0)).End().ToAscii()));
    }

    private static IReadOnlyList<string> Differences(byte[] file) => SecondOpinion.Of(file).DifferencesFrom(DrawingSummary.Of(DxfReader.Read(file, "test.dxf", DxfReadOptions.Default, CancellationToken.None)));
}
