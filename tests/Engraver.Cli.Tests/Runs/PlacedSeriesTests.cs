using System.Text;
using System.Text.Json;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Copies of a plate with serial text and operations, on the back of a blank.</summary>
public sealed class PlacedSeriesTests : IDisposable
{
    private const string Operations = """
        { "version": "1.0", "tools": [{"number": 1, "diameter": 1}], "operations": [
          { "id": "text", "kind": "engrave", "select": {"layers": ["TEXT"]}, "tool": 1, "depth": 0.2 },
          { "id": "outline", "kind": "profile", "select": "rest", "side": "outside", "tool": 1, "depth": 0.5 } ] }
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Five_copies_are_interrupted_in_the_third_and_resumed_with_the_same_placement_only()
    {
        string[] job = ["run", Drawing(), "--cut", "text", "--operations", _folder.WithFile("plate.operations.json", Operations), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--place", "corner", "--move", "2,2", "--copies", "5", "--grid", "2x1", "--pitch", "20,0", "--stagger", "0,3", "--connect", "sim:", "--json"];
        string[] back = ["--blank", "50,30", "--back", "y"];
        var stopped = await InterruptedSeries.InPlateThreeAsync("for plate 3", stop => stop.Cancel(), [.. job, .. back]);
        Assert.True(stopped.ExitCode == ExitCode.StoppedByOperator, stopped.Error);
        Assert.Equal(["complete", "complete", "stopped"], Plates(stopped).Select(Outcome));
        var journal = Plates(stopped)[2].GetProperty("journal").GetString()!;

        var other = await CliRun.RunAsync([.. job, "--resume", journal]);
        Assert.NotEqual(ExitCode.Done, other.ExitCode);
        var turned = await CliRun.RunAsync([.. job, "--blank", "50,30", "--back", "y", "--mirror", "x", "--resume", journal]);
        Assert.NotEqual(ExitCode.Done, turned.ExitCode);
        var resumed = await CliRun.Typing("\n\n\n", [.. job, .. back, "--resume", journal]);

        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.All(Plates(stopped).Take(2).Concat(Plates(resumed)), plate => Assert.Equal(("complete", 0.0), (Outcome(plate), plate.GetProperty("missingLength").GetDouble())));
        Assert.Equal(["placed=1, copy=1", "placed=2, copy=2", "placed=3, copy=3", "placed=4, copy=4", "placed=5, copy=5"], Plates(stopped).Take(2).Concat(Plates(resumed)).Select(plate => plate.GetProperty("text").GetString()));
        Assert.Equal([(0.0, 0.0), (-20.0, 3.0), (0.0, 0.0), (-20.0, 3.0), (0.0, 0.0)], Plates(stopped).Take(2).Concat(Plates(resumed)).Select(plate => (plate.GetProperty("x").GetDouble(), plate.GetProperty("y").GetDouble())));
    }

    [Theory]
    [InlineData("60,0", ExitCode.DrawingError)]
    [InlineData("30,0", ExitCode.Done)]
    public async Task Nothing_starts_if_a_later_copy_would_leave_the_travel(string pitch, int code)
    {
        var machine = _folder.WithFile("short.json", """{ "travelX": { "min": -1, "max": 70 }, "travelY": { "min": -1, "max": 70 } }""");
        var run = await CliRun.RunAsync("run", Drawing(), "--grid", "2x1", "--pitch", pitch, "--machine", machine, "--connect", "sim:", "--json");

        Assert.Equal(code, run.ExitCode);
        Assert.Equal(code != ExitCode.Done, run.Error.Contains("JOB0030", StringComparison.Ordinal));
        Assert.Equal(code == ExitCode.Done ? ["complete", "complete"] : ["refused"], Plates(run).Select(Outcome));
    }

    [Fact]
    public async Task Plan_and_plot_have_every_copy()
    {
        string[] grid = ["--grid", "2x2", "--pitch", "20,10", "--stagger", "7,0"];
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", Drawing(), "--json", .. grid]));
        var picture = _folder.PathOf("plates.svg");
        var plot = await CliRun.RunAsync(["plot", Drawing(), "-o", picture, .. grid]);

        Assert.Equal([(0.0, 0.0), (20.0, 0.0), (7.0, 10.0), (27.0, 10.0)], plan.GetProperty("plates").EnumerateArray().Select(plate => (plate.GetProperty("x").GetDouble(), plate.GetProperty("y").GetDouble())));
        Assert.All(plan.GetProperty("plates").EnumerateArray(), plate => Assert.True(plate.GetProperty("seconds").GetDouble() > 1.0));
        Assert.True(plot.ExitCode == ExitCode.Done, plot.Error);
        Assert.Contains("4 strokes", await File.ReadAllTextAsync(picture), StringComparison.Ordinal);
        Assert.Contains("42 x 16 mm", await File.ReadAllTextAsync(picture), StringComparison.Ordinal);
        Assert.Contains("--stagger requires --grid", (await CliRun.RunAsync("plan", Drawing(), "--stagger", "1,1")).Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--back needs the size", "--back", "x")]
    [InlineData("differ by 1 mm", "--align", "0,0:10,0", "--to", "0,0:0,11")]
    [InlineData("--align and --to", "--to", "0,0:0,11")]
    [InlineData("is not a pair", "--align", "0,0:0,0")]
    [InlineData("is not a width", "--blank", "10,0")]
    [InlineData("--align cannot be used with --place", "--align", "0,0:10,0", "--to", "0,0:0,10", "--place", "corner")]
    public async Task A_placement_that_is_incomplete_is_refused(string message, params string[] options)
    {
        var run = await CliRun.RunAsync(["info", Drawing(), .. options]);
        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    private static string? Outcome(JsonElement plate) => plate.GetProperty("outcome").GetString();

    private static IReadOnlyList<JsonElement> Plates(CliRun run) => [.. JsonText.Of(run).GetProperty("plates").EnumerateArray()];

    /// <summary>15 by 6 mm, with a number.</summary>
    private string Drawing() => _folder.WithFile("plate.dxf", Encoding.UTF8.GetString(DxfText.WithEntities(
        (0, "LWPOLYLINE"), (8, "0"), (90, 4), (70, 1), (10, 0.0), (20, 0.0), (10, 15.0), (20, 0.0), (10, 15.0), (20, 6.0), (10, 0.0), (20, 6.0),
        (0, "TEXT"), (8, "TEXT"), (10, 2.0), (20, 2.0), (40, 2.0), (1, "[[n placed:00]] [[copy]]")).ToAscii()));
}
