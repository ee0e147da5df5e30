using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A named pipe given for a result is written, not replaced.</summary>
public class PipeTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(2);

    [Fact]
    public async Task Trace_and_journal_go_into_pipes_and_their_readers_get_all_of_it()
    {
        if (OperatingSystem.IsWindows()) return; // The system has no named pipes in the file system.
        using var folder = new TemporaryFolder();
        var (trace, journal) = (NamedPipe.Make(folder.PathOf("trace")), NamedPipe.Make(folder.PathOf("journal")));
        var (traced, journalled) = (NamedPipe.ReadAsync(trace), NamedPipe.ReadAsync(journal));
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--trace", trace, "--journal", journal).WaitAsync(s_patience);

        Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        Assert.Contains(" A > BGS\n", await traced.WaitAsync(s_patience), StringComparison.Ordinal);
        Assert.Contains("\"kind\":\"end\"", await journalled.WaitAsync(s_patience), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_program_that_is_posted_into_a_pipe_arrives_and_the_pipe_stays_one()
    {
        if (OperatingSystem.IsWindows()) return; // The system has no named pipes in the file system.
        using var folder = new TemporaryFolder();
        var pipe = NamedPipe.Make(folder.PathOf("program.dmc"));
        var said = await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "galil");
        foreach (var time in (string[])["first", "second"])
        {
            var read = NamedPipe.ReadAsync(pipe);
            var run = await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "galil", "-o", pipe);

            Assert.Equal((time, ExitCode.Done, said.Out), (time, run.ExitCode, await read.WaitAsync(s_patience)));
        }

        Assert.Single(Directory.GetFileSystemEntries(Path.GetDirectoryName(pipe)!));
    }
}
