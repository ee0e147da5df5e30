using System.Text;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A run on a terminal asks whether texts are engraved; other runs only warn.</summary>
public class TextQuestionTests
{
    [Theory]
    [InlineData("y\n", true)]
    [InlineData("\n", false)]
    [InlineData("n\n", false)]
    public async Task A_terminal_is_asked_once(string answer, bool engraves)
    {
        using var folder = new TemporaryFolder();
        var run = await TypingAsync(answer, "run", Write(folder), "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"));

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(2, run.Error.Split("1 text is not cut. Engrave it?").Length);
        Assert.Equal(engraves, !run.Error.Contains("JOB0001", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_run_without_a_terminal_warns_and_says_how()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.Typing("y\n", "run", Write(folder), "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"));

        Assert.DoesNotContain("Engrave it?", run.Error, StringComparison.Ordinal);
        Assert.Contains("JOB0001", run.Error, StringComparison.Ordinal);
        Assert.Contains("--cut", run.Error, StringComparison.Ordinal);
    }

    private static string Write(TemporaryFolder folder)
    {
        var path = folder.PathOf("text.dxf");
        File.WriteAllBytes(path, DxfText.WithEntities((0, "LINE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0), (0, "TEXT"), (8, "0"), (10, 0.0), (20, 5.0), (40, 5.0), (1, "LH")).ToAscii());
        return path;
    }

    private static async Task<CliRun> TypingAsync(string input, params string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        int code;
        using (var streams = new ConsoleStreams(output, error, new StringReader(input)) { Interactive = true })
        {
            code = await EngraverProgram.RunAsync(args, streams, CancellationToken.None);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }
}
