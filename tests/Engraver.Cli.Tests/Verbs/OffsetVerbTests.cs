namespace Engraver.Cli.Tests.Verbs;

public class OffsetVerbTests
{
    private const string Square = "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n20\n20\n0\n10\n20\n20\n20\n10\n0\n20\n20\n";
    private const string Line = "0\nLINE\n8\n0\n10\n30\n20\n0\n11\n40\n21\n0\n";

    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("offset", FileOf(folder, Square), "--distance", "2", "--side", "out", "--json");
        var offset = JsonText.Of(run);
        var loop = Assert.Single(offset.GetProperty("loops").EnumerateArray());

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(["loops", "maxDeviation"], offset.EnumerateObject().Select(field => field.Name));
        Assert.Equal(["closed", "lines", "arcs", "length", "area", "hole"], loop.EnumerateObject().Select(field => field.Name));
        Assert.Equal((true, 4, 4), (loop.GetProperty("closed").GetBoolean(), loop.GetProperty("lines").GetInt32(), loop.GetProperty("arcs").GetInt32()));
        Assert.Equal(80.0 + (4.0 * Math.PI), loop.GetProperty("length").GetDouble(), 9);
        Assert.Equal(400.0 + 160.0 + (4.0 * Math.PI), loop.GetProperty("area").GetDouble(), 9);
        Assert.True(offset.GetProperty("maxDeviation").GetDouble() < 1e-9);
    }

    [Theory]
    [InlineData("round", 4, 4)]
    [InlineData("mitre", 4, 0)]
    [InlineData("bevel", 8, 0)]
    public async Task Corners_have_the_join_that_is_asked_for(string join, int lines, int arcs)
    {
        using var folder = new TemporaryFolder();
        var loop = JsonText.Of(await CliRun.RunAsync("offset", FileOf(folder, Square), "--distance", "2", "--side", "out", "--join", join, "--json")).GetProperty("loops")[0];

        Assert.Equal((lines, arcs), (loop.GetProperty("lines").GetInt32(), loop.GetProperty("arcs").GetInt32()));
    }

    [Fact]
    public async Task The_drawing_that_is_written_reads_back_as_the_offset()
    {
        using var folder = new TemporaryFolder();
        var written = folder.PathOf("out.dxf");
        await CliRun.RunAsync("offset", SampleDrawing.PathOf("gasket"), "--distance", "0.5", "--side", "in", "-o", written);
        var again = JsonText.Of(await CliRun.RunAsync("sequence", written, "--json"));

        Assert.Equal((47, 47), (again.GetProperty("contours").GetInt32(), again.GetProperty("closed").GetInt32()));
        Assert.Equal(1160.211472, again.GetProperty("pathLength").GetDouble(), 6);
    }

    [Fact]
    public async Task Nothing_left_is_a_result_and_a_warning()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("offset", FileOf(folder, Square), "--distance", "10", "--side", "in", "--json");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Empty(JsonText.Of(run).GetProperty("loops").EnumerateArray());
        Assert.Contains("OFF0002", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Open_contours_are_left_out_inwards_and_that_is_said()
    {
        using var folder = new TemporaryFolder();
        var (mixed, open) = (await CliRun.RunAsync("offset", FileOf(folder, Square + Line), "--distance", "1", "--side", "in", "--json"), await CliRun.RunAsync("offset", FileOf(folder, Line), "--distance", "1", "--side", "in", "--json"));

        Assert.Equal((ExitCode.Done, ExitCode.DrawingError), (mixed.ExitCode, open.ExitCode));
        Assert.Contains("OFF0001", mixed.Error, StringComparison.Ordinal);
        Assert.Contains("OFF0004", open.Error, StringComparison.Ordinal);
        Assert.Single(JsonText.Of(mixed).GetProperty("loops").EnumerateArray());
        Assert.Empty(JsonText.Of(open).GetProperty("loops").EnumerateArray());
    }

    [Theory]
    [InlineData("--distance", "0", "--side", "in")]
    [InlineData("--distance", "-1", "--side", "in")]
    [InlineData("--distance", "NaN", "--side", "in")]
    [InlineData("--distance", "1,5", "--side", "in")]
    [InlineData("--distance", "1", "--side", "inside")]
    [InlineData("--distance", "1")]
    [InlineData("--side", "in")]
    [InlineData("--distance", "1", "--side", "in", "--join", "square")]
    [InlineData("--distance", "1", "--side", "in", "--mitre-limit", "0.5")]
    public async Task What_cannot_be_read_is_a_usage_error(params string[] options)
    {
        var run = await CliRun.RunAsync(["offset", SampleDrawing.PathOf("gasket"), .. options]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Equal("", run.Out);
    }

    [Fact]
    public async Task A_file_that_is_not_there_is_one_diagnostic_and_an_empty_object()
    {
        var run = await CliRun.RunAsync("offset", "/nowhere/none.dxf", "--distance", "1", "--side", "in", "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Empty(JsonText.Of(run).GetProperty("loops").EnumerateArray());
        Assert.Equal(1, run.Error.Split("error").Length - 1);
    }

    private static string FileOf(TemporaryFolder folder, string entities) => folder.WithFile("drawing.dxf", $"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
}
