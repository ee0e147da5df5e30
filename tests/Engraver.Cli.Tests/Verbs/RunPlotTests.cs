namespace Engraver.Cli.Tests.Verbs;

/// <summary><c>plot --what deviation|speed</c>: from the trace saved with the journal of a run.</summary>
public class RunPlotTests
{
    [Theory]
    [InlineData("deviation")]
    [InlineData("speed")]
    public async Task A_run_is_drawn_from_what_was_kept_beside_its_journal(string what)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--journal", folder.PathOf("run.jsonl"));
        Assert.True(run.ExitCode == ExitCode.Done, run.Error);

        var plot = await CliRun.RunAsync("plot", SampleDrawing.PathOf("paper-001"), "--what", what, "--journal", folder.PathOf("run.jsonl"), "-o", folder.PathOf("run.svg"));

        Assert.True(plot.ExitCode == ExitCode.Done, plot.Error);
        var svg = await File.ReadAllTextAsync(folder.PathOf("run.svg"));
        Assert.Contains("class=\"cut heat15\"", svg, StringComparison.Ordinal); // the worst, or the fastest
        Assert.Contains("class=\"cut base\"", svg, StringComparison.Ordinal); // the drawing beneath it
        var most = double.Parse(svg.Split("maximum ")[1].Split(' ')[0], System.Globalization.CultureInfo.InvariantCulture);
        Assert.InRange(most, what == "speed" ? 1190.0 : 0.0, what == "speed" ? 1225.0 : 0.004);
    }

    [Fact]
    public async Task Without_a_journal_the_last_run_of_the_drawing_is_taken_and_without_a_run_it_says_what_to_do()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.PathOf($"own-{Environment.ProcessId}.dxf");
        File.Copy(SampleDrawing.PathOf("paper-001"), drawing);
        var none = await CliRun.RunAsync("plot", drawing, "--what", "deviation", "-o", folder.PathOf("run.svg"));
        Assert.Equal(ExitCode.Usage, none.ExitCode);
        Assert.Contains("--journal", none.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder.PathOf("run.svg")));

        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("run", drawing, "--connect", "sim:")).ExitCode);
        var plot = await CliRun.RunAsync("plot", drawing, "--what", "deviation", "-o", folder.PathOf("run.svg"));
        Assert.True(plot.ExitCode == ExitCode.Done, plot.Error);
        Assert.True(File.Exists(folder.PathOf("run.svg")));
    }
}
