namespace Engraver.Cli.Tests.Verbs;

public class SequenceVerbTests
{
    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        var sequence = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf("nested-logo"), "--json"));

        Assert.Equal(
            ["contours", "closed", "open", "segments", "reversed", "duplicatesRemoved", "pathLength", "travel", "travelAndBack", "travelAsDrawn", "strokes", "discontinuities", "seconds"],
            sequence.EnumerateObject().Select(field => field.Name));
        Assert.Equal(sequence.GetProperty("contours").GetInt32(), sequence.GetProperty("strokes").GetArrayLength());
        Assert.True(sequence.GetProperty("travel").GetDouble() < sequence.GetProperty("travelAsDrawn").GetDouble());
    }

    [Fact]
    public async Task An_inner_stroke_comes_before_the_one_around_it()
    {
        var strokes = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf("nested-logo"), "--json")).GetProperty("strokes");

        Assert.Contains(strokes.EnumerateArray(), stroke => stroke.GetProperty("inside").GetInt32() >= 0);
        Assert.All(strokes.EnumerateArray(), stroke =>
            Assert.True(stroke.GetProperty("inside").GetInt32() is -1 || stroke.GetProperty("inside").GetInt32() > stroke.GetProperty("index").GetInt32()));
    }

    [Fact]
    public async Task The_papers_part_is_one_closed_contour_and_can_be_entered_where_the_operator_says()
    {
        var sequence = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf("paper-001"), "--json", "--enter", "150,150"));
        var stroke = sequence.GetProperty("strokes")[0];

        Assert.Equal(1, sequence.GetProperty("closed").GetInt32());
        Assert.Equal(300.0 + (50.0 * Math.PI), sequence.GetProperty("pathLength").GetDouble(), precision: 9);
        Assert.Equal((150.0, 150.0), (stroke.GetProperty("startX").GetDouble(), stroke.GetProperty("startY").GetDouble()));
    }

    [Fact]
    public async Task Every_end_of_an_open_stroke_is_a_discontinuity_with_its_gap()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("gap.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n5\nA1\n8\n0\n10\n0\n20\n0\n11\n10\n21\n0\n0\nLINE\n5\nB2\n8\n0\n10\n10.02\n20\n0\n11\n10\n21\n10\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("sequence", file, "--json");
        var ends = JsonText.Of(run).GetProperty("discontinuities");

        Assert.Equal(4, ends.GetArrayLength());
        Assert.Equal(2, ends.EnumerateArray().Count(end => Math.Abs(end.GetProperty("gap").GetDouble() - 0.02) < 1e-9 && end.GetProperty("id").GetString() == "SEQ0003"));
        Assert.Contains("SEQ0003", run.Error, StringComparison.Ordinal);
        Assert.Equal(0, JsonText.Of(await CliRun.RunAsync("sequence", file, "--json", "--join-tolerance", "0.03")).GetProperty("discontinuities").EnumerateArray()
            .Count(end => end.GetProperty("gap").GetDouble() < 1.0));
    }
}
