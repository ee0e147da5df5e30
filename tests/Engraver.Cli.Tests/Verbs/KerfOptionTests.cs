namespace Engraver.Cli.Tests.Verbs;

/// <summary><c>--kerf</c> and <c>--tool-diameter</c> of the verbs that cut: a gasket-like plate of 40 x 20 with a hole of radius 5.</summary>
public class KerfOptionTests
{
    private const string Plate = "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n40\n20\n0\n10\n40\n20\n20\n10\n0\n20\n20\n0\nCIRCLE\n8\n0\n10\n20\n20\n10\n40\n5\n";

    [Fact]
    public async Task A_plan_is_of_the_compensated_path()
    {
        using var folder = new TemporaryFolder();
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", FileOf(folder), "--kerf", "nesting", "--tool-diameter", "4", "--json"]));

        Assert.Equal(120.0 + (4.0 * Math.PI) + (6.0 * Math.PI), plan.GetProperty("cutLength").GetDouble(), 2);
    }

    /// <summary>The posted program follows the compensated path and no other; without the option it differs from the drawing.</summary>
    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    public async Task What_is_posted_is_verified_against_the_compensated_path(string target)
    {
        using var folder = new TemporaryFolder();
        var (file, program) = (FileOf(folder), folder.PathOf("program.txt"));
        string[] kerf = ["--kerf", "nesting", "--tool-diameter", "4"];
        var posted = await CliRun.RunAsync(["post", file, "--target", target, "-o", program, .. kerf]);
        var same = await CliRun.RunAsync(["verify", program, "--against", file, "--target", target, "--json", .. kerf]);
        var onTheLine = await CliRun.RunAsync(["verify", program, "--against", file, "--target", target, "--json"]);

        Assert.Equal((ExitCode.Done, ExitCode.Done), (posted.ExitCode, same.ExitCode));
        Assert.True(JsonText.Of(same).GetProperty("ok").GetBoolean());
        Assert.NotEqual(ExitCode.Done, onTheLine.ExitCode);
        Assert.Equal(2.0, JsonText.Of(onTheLine).GetProperty("maxDeviation").GetDouble(), 1);
    }

    [Fact]
    public async Task Corners_that_are_not_reached_are_told()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("plan", FileOf(folder), "--kerf", "inside", "--tool-diameter", "4");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("KRF0001", run.Error, StringComparison.Ordinal);
        Assert.Contains("0.828427", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_plan_lists_the_places_that_are_not_reached()
    {
        using var folder = new TemporaryFolder();
        var inside = JsonText.Of(await CliRun.RunAsync("plan", FileOf(folder), "--kerf", "inside", "--tool-diameter", "4", "--json")).GetProperty("uncut").EnumerateArray().ToList();
        var narrow = JsonText.Of(await CliRun.RunAsync("plan", FileOf(folder), "--kerf", "inside", "--tool-diameter", "11", "--json")).GetProperty("uncut").EnumerateArray().ToList();
        var none = JsonText.Of(await CliRun.RunAsync("plan", FileOf(folder), "--json")).GetProperty("uncut");

        Assert.Equal(["x", "y", "distance", "whole"], inside[0].EnumerateObject().Select(field => field.Name));
        Assert.Equal([(0.0, 0.0), (0.0, 20.0), (40.0, 0.0), (40.0, 20.0)], inside.Select(place => (place.GetProperty("x").GetDouble(), place.GetProperty("y").GetDouble())).Order());
        Assert.All(inside, place => Assert.Equal((0.828427, false), (Math.Round(place.GetProperty("distance").GetDouble(), 6), place.GetProperty("whole").GetBoolean())));
        Assert.Single(narrow, place => place.GetProperty("whole").GetBoolean()); // the hole
        Assert.Equal(0, none.GetArrayLength());
    }

    [Fact]
    public async Task The_sequence_its_CL_data_and_the_table_are_of_the_compensated_path()
    {
        using var folder = new TemporaryFolder();
        var cl = folder.PathOf("cl.dxf");
        string[] kerf = ["--kerf", "nesting", "--tool-diameter", "4"];
        var sequence = JsonText.Of(await CliRun.RunAsync(["sequence", FileOf(folder), "--json", "-o", cl, .. kerf]));
        var table = await CliRun.RunAsync(["table", FileOf(folder), "--format", "csv", .. kerf]);
        var drawn = await CliRun.RunAsync(["table", FileOf(folder), "--format", "csv", "--as-drawn", .. kerf]);
        var again = JsonText.Of(await CliRun.RunAsync("sequence", cl, "--json"));

        Assert.Equal(120.0 + (4.0 * Math.PI) + (6.0 * Math.PI), sequence.GetProperty("pathLength").GetDouble(), 6);
        Assert.Equal(sequence.GetProperty("pathLength").GetDouble(), again.GetProperty("pathLength").GetDouble(), 6);
        Assert.Equal((9, 2), (sequence.GetProperty("segments").GetInt32(), sequence.GetProperty("contours").GetInt32()));
        Assert.Equal((1 + 9, 1 + 5), (table.Out.Trim().Split('\n').Length, drawn.Out.Trim().Split('\n').Length));
    }

    [Theory]
    [InlineData("sequence")]
    [InlineData("table")]
    public async Task What_is_not_reached_is_told_by_the_sequence_and_the_table_too(string verb)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(verb, FileOf(folder), "--kerf", "inside", "--tool-diameter", "4");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("KRF0001", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Automatically created trajectories follow the compensated path as well.</summary>
    [Fact]
    public async Task Trajectories_run_beside_the_lines()
    {
        using var folder = new TemporaryFolder();
        var run = JsonText.Of(await CliRun.RunAsync("run", FileOf(folder), "--connect", "sim:?speed=max", "--json", "--trajectory", "--journal", folder.PathOf("j.jsonl"), "--kerf", "nesting", "--tool-diameter", "4"));

        Assert.Equal(0.0, run.GetProperty("missingLength").GetDouble());
        var made = JsonText.Of(await CliRun.RunAsync("trajectory", FileOf(folder), "-o", folder.PathOf("out"), "--json", "--kerf", "nesting", "--tool-diameter", "4"));
        Assert.Equal(120.0 + (10.0 * Math.PI), made.GetProperty("trajectories").EnumerateArray().Sum(one => one.GetProperty("length").GetDouble()), 6);
    }

    [Fact]
    public async Task A_kerf_without_a_tool_is_a_usage_error()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("plan", FileOf(folder), "--kerf", "nesting");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--tool-diameter", run.Error, StringComparison.Ordinal);
    }

    private static string FileOf(TemporaryFolder folder)
    {
        var file = folder.PathOf("plate.dxf");
        File.WriteAllText(file, $"0\nSECTION\n2\nENTITIES\n{Plate}0\nENDSEC\n0\nEOF\n");
        return file;
    }
}
