namespace Engraver.Cli.Tests.Verbs;

public class MinimiseVerbTests
{
    [Fact]
    public async Task The_smallest_drawing_that_shows_the_fault_is_written()
    {
        using var folder = new TemporaryFolder();
        var whole = await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001"));
        var faulty = folder.WithFile("faulty.dxf", whole.Replace("ENTITIES\n", "ENTITIES\n0\nCIRCLE\n5\nFFF\n8\n0\n10\n3.5\n20\n0\n40\n-2\n", StringComparison.Ordinal));
        var small = folder.PathOf("small.dxf");

        var run = await CliRun.RunAsync("minimise", faulty, "--keep", "DXF0011", "-o", small);
        var info = await CliRun.RunAsync("info", small);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("DXF0011", info.Error, StringComparison.Ordinal);
        Assert.True(new FileInfo(small).Length < 100, await File.ReadAllTextAsync(small));
    }

    [Fact]
    public async Task Without_the_fault_nothing_is_written_and_it_is_exit_1()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("minimise", SampleDrawing.PathOf("paper-001"), "--keep", "crash", "-o", folder.PathOf("none.dxf"));

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains("does not show crash", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder.PathOf("none.dxf")));
    }

    [Fact]
    public async Task A_missing_file_is_exit_1()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("minimise", folder.PathOf("nowhere.dxf"), "--keep", "DXF0011");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Single(run.Error.TrimEnd().Split('\n'));
    }
}
