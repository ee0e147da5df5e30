namespace Engraver.Cli.Tests.Verbs;

public class PocketVerbTests
{
    private const string Square = "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n20\n20\n0\n10\n20\n20\n20\n10\n0\n20\n20\n";
    private const string Island = "0\nCIRCLE\n8\n0\n10\n10\n20\n10\n40\n3\n";
    private const string Narrow = "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n30\n20\n0\n10\n40\n20\n0\n10\n40\n20\n1.5\n10\n30\n20\n1.5\n";
    private const string Line = "0\nLINE\n8\n0\n10\n30\n20\n5\n11\n40\n21\n5\n";

    /// <summary>A square of 20 as one edge path of lines.</summary>
    private const string Hatch = "0\nHATCH\n8\n0\n10\n0\n20\n0\n30\n0\n2\nSOLID\n70\n1\n71\n0\n91\n1\n92\n2\n72\n0\n73\n1\n93\n4\n10\n0\n20\n0\n10\n20\n20\n0\n10\n20\n20\n20\n10\n0\n20\n20\n97\n0\n75\n0\n76\n1\n98\n0\n";

    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("pocket", FileOf(folder, Square + Island), "--tool", "1", "--stepover", "0.5", "--json");
        var pocket = JsonText.Of(run);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(
            ["loops", "maxDeviation", "regions", "drawnArea", "reachableArea", "coveredArea", "uncoveredArea", "coverage", "unreachableArea", "unreached", "tooNarrow", "levels", "strokes", "stepover", "passDistance", "passOverlap"],
            pocket.EnumerateObject().Select(field => field.Name));
        Assert.Equal(["closed", "lines", "arcs", "length", "area", "hole", "kind", "level", "region"], pocket.GetProperty("loops")[0].EnumerateObject().Select(field => field.Name));
        Assert.Equal(["region", "finish", "z", "entry", "startX", "startY", "endX", "endY", "cutLength", "linkLength"], Assert.Single(pocket.GetProperty("strokes").EnumerateArray()).EnumerateObject().Select(field => field.Name));
        Assert.Equal(400.0 - (9.0 * Math.PI), pocket.GetProperty("drawnArea").GetDouble(), 9);
        Assert.Equal(4.0 - Math.PI, pocket.GetProperty("unreachableArea").GetDouble(), 9);
        Assert.Equal(1.0, pocket.GetProperty("coverage").GetDouble(), 9);
        Assert.Equal(4, pocket.GetProperty("unreached").GetArrayLength());
        Assert.True(pocket.GetProperty("maxDeviation").GetDouble() < 1e-9);
    }

    [Theory]
    [InlineData("ramp")]
    [InlineData("helix")]
    [InlineData("plunge")]
    public async Task The_drawing_that_is_written_runs_on_a_mill(string entry)
    {
        using var folder = new TemporaryFolder();
        var written = folder.PathOf("pocket.dxf");
        var pocket = JsonText.Of(await CliRun.RunAsync("pocket", FileOf(folder, Square + Island), "--tool", "1.5", "--stepover", "0.6", "--depth", "2", "--step", "0.8", "--entry", entry, "--allowance", "0.2", "-o", written, "--json"));
        var run = await CliRun.RunAsync("run", written, "--connect", "sim:?speed=max", "--machine", SampleDrawing.MillProfile, "--order", "drawn", "--journal", folder.PathOf("journal"), "--json");
        var cut = JsonText.Of(run);

        Assert.Equal(3, pocket.GetProperty("levels").GetArrayLength());
        Assert.Equal(-2.0, pocket.GetProperty("levels")[2].GetDouble());
        Assert.All(pocket.GetProperty("strokes").EnumerateArray(), stroke => Assert.Equal(entry, stroke.GetProperty("entry").GetString()));
        Assert.Equal((ExitCode.Done, "complete"), (run.ExitCode, cut.GetProperty("outcome").GetString()));
        Assert.True(cut.GetProperty("maxDeviation").GetDouble() < 0.01);
        Assert.Equal(0.0, cut.GetProperty("missingLength").GetDouble(), 3);
    }

    [Fact]
    public async Task The_drawing_that_is_written_is_planned_posted_and_verified()
    {
        using var folder = new TemporaryFolder();
        var (written, program) = (folder.PathOf("pocket.dxf"), folder.PathOf("pocket.dmc"));
        await CliRun.RunAsync("pocket", FileOf(folder, Square), "--tool", "2", "--stepover", "0.5", "--depth", "1", "--entry", "ramp", "-o", written);
        var plan = await CliRun.RunAsync("plan", written, "--machine", SampleDrawing.MillProfile, "--order", "drawn", "--json");
        var post = await CliRun.RunAsync("post", written, "--target", "galil", "--machine", SampleDrawing.MillProfile, "--order", "drawn", "-o", program);
        var verify = await CliRun.RunAsync("verify", program, "--against", written, "--target", "galil", "--machine", SampleDrawing.MillProfile, "--order", "drawn", "--json");

        Assert.Equal((ExitCode.Done, ExitCode.Done, ExitCode.Done), (plan.ExitCode, post.ExitCode, verify.ExitCode));
        Assert.True(JsonText.Of(verify).GetProperty("ok").GetBoolean());
        Assert.True(JsonText.Of(plan).GetProperty("cutLength").GetDouble() > 100.0);
    }

    [Fact]
    public async Task The_boundary_of_a_hatch_is_a_pocket()
    {
        using var folder = new TemporaryFolder();
        var (without, with) = (await CliRun.RunAsync("pocket", FileOf(folder, Hatch), "--tool", "1", "--stepover", "0.5", "--json"), await CliRun.RunAsync("pocket", FileOf(folder, Hatch), "--tool", "1", "--stepover", "0.5", "--cut", "hatch", "--json"));

        Assert.Equal(ExitCode.DrawingError, without.ExitCode);
        Assert.Contains("POC0005", without.Error, StringComparison.Ordinal);
        Assert.Equal(400.0, JsonText.Of(with).GetProperty("drawnArea").GetDouble(), 9);
        Assert.Equal(1.0, JsonText.Of(with).GetProperty("coverage").GetDouble(), 9);
    }

    [Fact]
    public async Task A_region_that_is_too_narrow_is_told_and_the_others_are_cleared()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("pocket", FileOf(folder, Square + Narrow + Line), "--tool", "1", "--stepover", "0.5", "--json");
        var narrow = Assert.Single(JsonText.Of(run).GetProperty("tooNarrow").EnumerateArray());

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(1.5, narrow.GetProperty("width").GetDouble(), 5);
        Assert.Contains("POC0001", run.Error, StringComparison.Ordinal);
        Assert.Contains("POC0006", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_tool_that_fits_into_nothing_covers_nothing()
    {
        using var folder = new TemporaryFolder();
        var file = FileOf(folder, Square);
        var (text, json) = (await CliRun.RunAsync("pocket", file, "--tool", "11", "--stepover", "0.5"), await CliRun.RunAsync("pocket", file, "--tool", "11", "--stepover", "0.5", "--json"));

        Assert.Contains("covered: nothing", text.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("100 %", text.Out, StringComparison.Ordinal);
        Assert.Equal(System.Text.Json.JsonValueKind.Null, JsonText.Of(json).GetProperty("coverage").ValueKind);
        Assert.Contains("POC0001", json.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_text_tells_coverage_and_corners()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("pocket", FileOf(folder, Square), "--tool", "1", "--stepover", "0.9", "--strategy", "zigzag", "--angle", "45");

        Assert.Contains("covered: 100 %", run.Out, StringComparison.Ordinal);
        Assert.Contains("0.858407 mm2 in 4 places", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--tool", "0", "--stepover", "0.5")]
    [InlineData("--tool", "1", "--stepover", "1")]
    [InlineData("--tool", "1", "--stepover", "0")]
    [InlineData("--tool", "1")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--overlap", "0.5")]
    [InlineData("--stepover", "0.5")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--allowance", "1.1")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--step", "1")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--entry", "ramp")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--strategy", "spiral")]
    [InlineData("--tool", "1", "--stepover", "0.5", "--depth", "1", "--ramp-angle", "90")]
    public async Task What_cannot_be_read_is_a_usage_error(params string[] options)
    {
        var run = await CliRun.RunAsync(["pocket", SampleDrawing.PathOf("gasket"), .. options]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Equal("", run.Out);
    }

    [Fact]
    public async Task Overlap_is_the_deprecated_name_of_the_stepover_and_the_output_says_both_figures()
    {
        var (old, now) = (await CliRun.RunAsync("pocket", SampleDrawing.PathOf("gasket"), "--tool", "1", "--overlap", "0.3", "--json"), await CliRun.RunAsync("pocket", SampleDrawing.PathOf("gasket"), "--tool", "1", "--stepover", "0.3", "--json"));
        var text = await CliRun.RunAsync("pocket", SampleDrawing.PathOf("gasket"), "--tool", "1", "--stepover", "0.3");

        Assert.Equal(now.Out, old.Out);
        Assert.Contains("Use --stepover 0.3.", old.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("--overlap", now.Error, StringComparison.Ordinal);
        Assert.Equal((0.3, 0.6, 1.4), (JsonText.Of(now).GetProperty("stepover").GetDouble(), JsonText.Of(now).GetProperty("passDistance").GetDouble(), Math.Round(JsonText.Of(now).GetProperty("passOverlap").GetDouble(), 9)));
        Assert.Contains("passes are 0.6 mm apart and overlap by 1.4 mm", text.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_is_not_there_is_one_diagnostic_and_an_empty_object()
    {
        var run = await CliRun.RunAsync("pocket", "/nowhere/none.dxf", "--tool", "1", "--stepover", "0.5", "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Empty(JsonText.Of(run).GetProperty("loops").EnumerateArray());
        Assert.Equal(1, run.Error.Split("error").Length - 1);
    }

    private static string FileOf(TemporaryFolder folder, string entities) => folder.WithFile("drawing.dxf", $"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
}
