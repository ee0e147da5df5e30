using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

public class ScriptVerbTests
{
    public static TheoryData<string> Samples => [.. Directory.GetFiles(RepositoryFolder.Samples, "*.scr").Select(path => Path.GetFileName(path))];

    [Theory]
    [MemberData(nameof(Samples))]
    public async Task The_samples_open_check_sequence_post_and_run_a_drawing(string name)
    {
        var run = await CliRun.RunAsync("script", Path.Combine(RepositoryFolder.Samples, name));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("0 errors, ", run.Out, StringComparison.Ordinal);
        Assert.Contains("1 contour (1 closed, 0 open) of ", run.Out, StringComparison.Ordinal);
        Assert.Contains("#JOB", run.Out, StringComparison.Ordinal);
        Assert.Matches(@"\ncomplete: .* the whole drawing was cut\.\n$", run.Out);
    }

    [Theory]
    [InlineData("OPEN nowhere.dxf\n", ExitCode.DrawingError, "a.scr(1): 'nowhere.dxf': nowhere.dxf was not opened")]
    [InlineData("\n\nFLY\n", ExitCode.Usage, "a.scr(3): 'FLY': Unknown command")]
    [InlineData("CNCCONNECT far\n", ExitCode.Usage, "a.scr(1): 'far': 'far' is not a controller address")]
    [InlineData("OPEN", ExitCode.Usage, "the script ended before OPEN was complete")]
    [InlineData("SCRIPT b.scr", ExitCode.Usage, "a.scr(1)")]
    [InlineData("", ExitCode.Done, "")]
    [InlineData("; nothing\n", ExitCode.Done, "")]
    public async Task A_failing_command_ends_the_script_with_file_and_line(string script, int code, string sentence)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("script", folder.WithFile("a.scr", script));

        Assert.Equal(code, run.ExitCode);
        Assert.Contains(sentence, run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nobody_at_the_other_end_is_exit_4_and_an_open_drawing_with_errors_exit_1()
    {
        using var folder = new TemporaryFolder();
        folder.WithFile("cut.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nLINE\n8\n0\n10\n0\n");
        using var listener = new System.Net.Sockets.TcpListener(System.Net.IPAddress.Loopback, 0);
        listener.Start();
        var port = ((System.Net.IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();

        Assert.Equal(ExitCode.LinkLost, (await CliRun.RunAsync("script", folder.WithFile("a.scr", FormattableString.Invariant($"CNCCONNECT tcp://127.0.0.1:{port}\n")))).ExitCode);
        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync("script", folder.WithFile("b.scr", "OPEN cut.dxf\nCNCORDER D\n"))).ExitCode);
    }

    [Fact]
    public async Task The_operators_stop_ends_a_running_script_with_exit_5()
    {
        using var folder = new TemporaryFolder();
        using var stop = new CancellationTokenSource();
        await stop.CancelAsync();
        var run = await CliRun.RunAsync(stop.Token, "script", folder.WithFile("a.scr", "HELP\n\n"));

        Assert.Equal(ExitCode.StoppedByOperator, run.ExitCode);
    }

    [Fact]
    public async Task Results_are_on_standard_output_and_the_dialogue_only_when_asked_for()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("a.scr", "DIST 0,0 3,4\n");
        var usual = await CliRun.RunAsync("script", file);
        var verbose = await CliRun.RunAsync("script", file, "--verbose");

        Assert.StartsWith("Distance = 5, ", usual.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("Command:", usual.Error, StringComparison.Ordinal);
        Assert.Contains("Specify second point: 3,4", verbose.Error, StringComparison.Ordinal);
    }
}
