namespace Engraver.Cli.Tests.Runs;

/// <summary><c>run --json</c> prints one object for every outcome, so that a script never has to parse an empty text.</summary>
public sealed class RunJsonTests
{
    [Theory]
    [InlineData(ExitCode.Usage, "refused", "--connect", "nowhere://x")]
    [InlineData(ExitCode.Usage, "refused")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--feed", "fast")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--quick")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--journal", "")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--machine", "/nowhere/machine.json")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--finish", "park")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--kerf", "outside")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--journal", "/nowhere/at/all.jsonl")]
    [InlineData(ExitCode.Usage, "refused", "--connect", "sim:", "--resume", "/nowhere/at/all.jsonl")]
    [InlineData(ExitCode.LinkLost, "linkLost", "--connect", "tcp://127.0.0.1:1")]
    [InlineData(ExitCode.LinkLost, "linkLost", "--connect", "serial:///dev/engraver-nothing")]
    public async Task There_is_always_one_object(int code, string outcome, params string[] options)
    {
        var run = await CliRun.RunAsync(["run", SampleDrawing.PathOf("paper-001"), "--json", .. options]);

        Assert.Equal((code, outcome), (run.ExitCode, JsonText.Of(run).GetProperty("outcome").GetString()));
        Assert.NotEmpty(run.Error);
    }

    [Fact]
    public async Task A_missing_drawing_is_an_object_too()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", folder.PathOf("nowhere.dxf"), "--connect", "sim:", "--json");

        Assert.Equal((ExitCode.DrawingError, "refused"), (run.ExitCode, JsonText.Of(run).GetProperty("outcome").GetString()));
    }

    /// <summary>Findings of the drawing are printed once, not again in the start checks.</summary>
    [Fact]
    public async Task A_finding_of_the_drawing_is_told_once()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("plate.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n10\n21\n0\n0\nTEXT\n8\n0\n10\n0\n20\n0\n40\n2\n1\nHI\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--journal", folder.PathOf("job.jsonl"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Single(run.Error.Split('\n'), line => line.Contains("Visible but not cut: 1 TEXT", StringComparison.Ordinal));
        Assert.Single(run.Error.Split('\n'), line => line.Contains("millimetres were assumed", StringComparison.Ordinal));
        Assert.Contains("visible but NOT CUT (1 TEXT)", run.Out, StringComparison.Ordinal);
    }
}
