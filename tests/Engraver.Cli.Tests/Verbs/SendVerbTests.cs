using System.Text;
using System.Text.Json;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

public class SendVerbTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);

    [Fact]
    public async Task A_posted_program_is_sent_and_received_as_it_was_posted()
    {
        using var folder = new TemporaryFolder();
        using var far = new PseudoTerminalPair();
        using var near = new PseudoTerminalPair();
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "agie", "-o", folder.PathOf("part.agie"))).ExitCode);
        using var told = new FirstLine();
        using var output = new MemoryStream();
        using var streams = new ConsoleStreams(output, told, TextReader.Null);
        var receiving = EngraverProgram.RunAsync(["receive", "--from", $"serial://{far.Device}?baud=115200&frame=7E1", "-o", folder.PathOf("heard.agie"), "--silence", "0.7", "--json"], streams, CancellationToken.None);
        await told.Written.WaitAsync(s_patience);
        var relaying = Task.Run(() => Relay(near, far));
        var sent = await CliRun.RunAsync("send", folder.PathOf("part.agie"), "--to", $"serial://{near.Device}?baud=115200&frame=7E1", "--leader", "30", "--trailer", "30", "--end-text", "\\x04", "--json");
        var code = await receiving.WaitAsync(s_patience);
        await relaying.WaitAsync(s_patience);

        var (posted, json, heard) = (File.ReadAllText(folder.PathOf("part.agie")), JsonText.Of(sent), JsonText.Of(new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), "")));
        Assert.Equal((ExitCode.Done, ExitCode.Done), (sent.ExitCode, code));
        Assert.Equal(posted + "\u0004\n", File.ReadAllText(folder.PathOf("heard.agie")));
        Assert.Equal(["outcome", "lines", "ofLines", "characters", "holds", "heard", "seconds", "reason"], json.EnumerateObject().Select(field => field.Name));
        Assert.Equal(("complete", posted.Count(letter => letter == '\n')), (json.GetProperty("outcome").GetString(), json.GetProperty("lines").GetInt32()));
        Assert.Equal(posted.Length + json.GetProperty("lines").GetInt32() + 61, json.GetProperty("characters").GetInt32());
        Assert.Equal(["outcome", "file", "lines", "characters", "damaged", "findings"], heard.EnumerateObject().Select(field => field.Name));
        Assert.Equal(("complete", folder.PathOf("heard.agie"), 0), (heard.GetProperty("outcome").GetString(), heard.GetProperty("file").GetString(), heard.GetProperty("damaged").GetInt32()));
    }

    [Fact]
    public async Task A_line_on_which_nothing_comes_ends_with_4_and_names_no_file()
    {
        using var folder = new TemporaryFolder();
        using var cable = new PseudoTerminalPair();
        var run = await CliRun.RunAsync("receive", "--from", $"serial://{cable.Device}?baud=115200", "-o", folder.PathOf("heard.nc"), "--silence", "0.2", "--json").WaitAsync(s_patience);

        Assert.Equal(ExitCode.LinkLost, run.ExitCode);
        Assert.Equal(("silent", JsonValueKind.Null), (JsonText.Of(run).GetProperty("outcome").GetString(), JsonText.Of(run).GetProperty("file").ValueKind));
        Assert.Contains("Nothing was received for 0.2 seconds", run.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(folder.PathOf("")));
    }

    /// <summary>An incomplete program is saved, but not under the name of a complete one.</summary>
    [Fact]
    public async Task A_stop_in_the_middle_of_a_program_ends_with_5_and_keeps_the_part_under_another_name()
    {
        using var folder = new TemporaryFolder();
        using var cable = new PseudoTerminalPair();
        using var stop = new CancellationTokenSource();
        using var told = new FirstLine();
        using var output = new MemoryStream();
        using var streams = new ConsoleStreams(output, told, TextReader.Null);
        File.WriteAllText(folder.PathOf("heard.nc"), "an older program");
        var receiving = EngraverProgram.RunAsync(["receive", "--from", $"serial://{cable.Device}?baud=115200", "-o", folder.PathOf("heard.nc"), "--silence", "600", "--json", "--verbose"], streams, stop.Token);
        await told.Written.WaitAsync(s_patience);
        cable.Write("G1 X1\r\n");
        await told.Second.WaitAsync(s_patience); // The line was received.
        await stop.CancelAsync();
        var code = await receiving.WaitAsync(s_patience);

        var json = JsonText.Of(new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), ""));
        Assert.Equal((ExitCode.StoppedByOperator, "stopped", folder.PathOf("heard.nc.part")), (code, json.GetProperty("outcome").GetString(), json.GetProperty("file").GetString()));
        Assert.Equal(("an older program", "G1 X1\n"), (File.ReadAllText(folder.PathOf("heard.nc")), File.ReadAllText(folder.PathOf("heard.nc.part"))));
    }

    [Fact]
    public async Task A_stop_ends_with_5_and_says_how_many_lines_are_out()
    {
        using var folder = new TemporaryFolder();
        using var cable = new PseudoTerminalPair();
        using var stop = new CancellationTokenSource();
        File.WriteAllLines(folder.PathOf("long.nc"), Enumerable.Repeat("G1 X1 Y1", 5000));
        var sending = CliRun.RunAsync(stop.Token, "send", folder.PathOf("long.nc"), "--to", $"serial://{cable.Device}?baud=19200");
        await Task.Run(() => cable.Read(200)).WaitAsync(s_patience);
        await stop.CancelAsync();
        var run = await sending.WaitAsync(s_patience);

        Assert.Equal((ExitCode.StoppedByOperator, ""), (run.ExitCode, run.Out));
        Assert.Matches("^engraver: Stopped: [0-9]+ of 5000 lines were sent.\n$", run.Error);
        Assert.InRange(int.Parse(run.Error.Split(' ')[2], System.Globalization.CultureInfo.InvariantCulture), 10, 4999);
    }

    /// <summary>A control sends its program once: an unwritable path is reported before listening.</summary>
    [Fact]
    public async Task A_place_that_cannot_be_written_and_an_endless_silence_are_refused_before_the_line_is_opened()
    {
        using var folder = new TemporaryFolder();
        string[] words = ["receive", "--from", "serial:///dev/engraver-nothing", "-o"];
        var missing = await CliRun.RunAsync([.. words, folder.PathOf("nowhere/x.nc")]);
        var directory = await CliRun.RunAsync([.. words, folder.PathOf("")]);
        var endless = await CliRun.RunAsync([.. words, folder.PathOf("x.nc"), "--silence", "1e300"]);
        var line = await CliRun.RunAsync([.. words, folder.PathOf("x.nc")]);

        Assert.Equal((ExitCode.Usage, ExitCode.Usage, ExitCode.Usage, ExitCode.LinkLost), (missing.ExitCode, directory.ExitCode, endless.ExitCode, line.ExitCode));
        Assert.Contains("the folder does not exist", missing.Error, StringComparison.Ordinal);
        Assert.Contains("86400", endless.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(folder.PathOf("")));
    }

    [Fact]
    public async Task A_file_with_several_programs_is_not_sent_at_once()
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("two.agie"), "%\t001\n\t002\n%\t001\n");
        var all = await CliRun.RunAsync("send", folder.PathOf("two.agie"), "--to", "serial:///dev/engraver-nothing");
        var third = await CliRun.RunAsync("send", folder.PathOf("two.agie"), "--to", "serial:///dev/engraver-nothing", "--program", "3");
        var nowhere = await CliRun.RunAsync("send", folder.PathOf("two.agie"), "--to", "serial:///dev/engraver-nothing", "--program", "2");

        Assert.Equal(ExitCode.DrawingError, all.ExitCode);
        Assert.Contains("SND0004: The file contains 2 programs", all.Error, StringComparison.Ordinal);
        Assert.Contains("SND0005: The file has no program 3; the number of its programs is 2.", third.Error, StringComparison.Ordinal);
        Assert.Equal(ExitCode.LinkLost, nowhere.ExitCode);
        Assert.Contains("No connection to /dev/engraver-nothing", nowhere.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--to", "tcp://localhost")]
    [InlineData("--to", "serial:///dev/x?baud=1")]
    [InlineData("--to", "serial:///dev/x", "--leader", "-1")]
    [InlineData("--to", "serial:///dev/x", "--line-delay", "much")]
    [InlineData("--to", "serial:///dev/x", "--start-text", "\\q")]
    [InlineData("--to", "serial:///dev/x?frame=7E1", "--start-text", "\\xFF")]
    [InlineData("--to", "serial:///dev/x", "--line-end", "none")]
    [InlineData]
    public async Task What_cannot_be_meant_is_a_usage_error(params string[] options)
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("a.nc"), "G1\n");

        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync(["send", folder.PathOf("a.nc"), .. options])).ExitCode);
    }

    /// <summary>Forwards the sender's data to the receiver, which pauses it from time to time.</summary>
    private static void Relay(PseudoTerminalPair from, PseudoTerminalPair to)
    {
        for (var turn = 0; from.ReadSome(64) is { Length: > 0 } some; turn++)
        {
            to.Write(some);
            if (turn % 5 != 0) continue;
            from.Write("\u0093"); // XOFF with the bit of an even parity
            from.Write("\u0011");
        }
    }

    /// <summary>Signals when the first and the second line were written.</summary>
    private sealed class FirstLine : StringWriter
    {
        private readonly TaskCompletionSource _written = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly TaskCompletionSource _second = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public Task Written => _written.Task;

        public Task Second => _second.Task;

        public override void WriteLine(string? value)
        {
            if (!_written.TrySetResult()) _second.TrySetResult();
        }

        public override Task WriteLineAsync(string? value)
        {
            WriteLine(value);
            return Task.CompletedTask;
        }

        public override Task WriteLineAsync(ReadOnlyMemory<char> buffer, CancellationToken cancellationToken = default)
        {
            WriteLine("");
            return Task.CompletedTask;
        }
    }
}
