using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A stopped run is continued with <c>--resume</c>: both runs together cut the drawing.</summary>
public sealed class ResumeRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("paper-001", "stream")]
    [InlineData("paper-001", "calls")]
    [InlineData("paper-001", "program")]
    [InlineData("gasket", "stream")]
    public async Task A_stopped_run_goes_on_from_its_journal(string drawing, string mode)
    {
        var journal = _folder.PathOf("first.jsonl");
        var first = await StoppedAsync(90, "run", SampleDrawing.PathOf(drawing), "--connect", "sim:", "--mode", mode, "--json", "--journal", journal);
        Assert.Equal((5, "stopped"), (first.ExitCode, Text(first, "outcome")));

        var second = await CliRun.RunAsync("run", SampleDrawing.PathOf(drawing), "--connect", "sim:", "--mode", mode, "--json", "--resume", journal, "--lead-in", "0.5", "--journal", _folder.PathOf("second.jsonl"));

        Assert.Equal((0, "complete"), (second.ExitCode, Text(second, "outcome")));
        var report = JsonText.Of(second);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        var from = report.GetProperty("resumedFrom");
        Assert.True(from.GetProperty("segments").GetInt32() > 0 || from.GetProperty("along").GetDouble() > 1.0, from.ToString());
        Assert.True(report.GetProperty("plannedSeconds").GetDouble() < JsonText.Of(first).GetProperty("plannedSeconds").GetDouble());
        Assert.Equal(JsonValueKind.Null, JsonText.Of(first).GetProperty("resumedFrom").ValueKind);
    }

    [Theory]
    [InlineData("gasket", "stream", "so the path differs")]
    [InlineData("paper-001", "calls", "mode stream")]
    public async Task A_journal_of_another_run_is_refused_before_anything_moves(string drawing, string mode, string reason)
    {
        var journal = _folder.PathOf("first.jsonl");
        await StoppedAsync(60, "run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--journal", journal);

        var second = await CliRun.RunAsync("run", SampleDrawing.PathOf(drawing), "--connect", "sim:", "--mode", mode, "--json", "--resume", journal);

        Assert.Equal((2, "refused"), (second.ExitCode, Text(second, "outcome")));
        Assert.Contains("JOB0040", second.Error, StringComparison.Ordinal);
        Assert.Contains(reason, second.Error, StringComparison.Ordinal);
    }

    /// <summary>Regression: the rest of a job was cut at another feed without a warning.</summary>
    [Fact]
    public async Task A_setting_that_is_not_that_of_the_journal_is_refused_with_both_values()
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json"];
        await StoppedAsync(60, [.. run, "--journal", journal]);
        var coarse = _folder.WithFile("coarse.json", """{"countsPerMillimetreX":500,"countsPerMillimetreY":500,"toolSettleSeconds":0.2,"costPerHour":60}""");

        await RefusedAsync("Feed was 1200 mm/min, now 600 mm/min", [.. run, "--resume", journal, "--feed", "600"]);
        await RefusedAsync("Order of strokes was nearest, now drawn", [.. run, "--resume", journal, "--order", "drawn"]);
        await RefusedAsync("countsPerMillimetreX was 1000, now 500; countsPerMillimetreY was 1000, now 500; toolSettleSeconds was 0.1, now 0.2.", [.. run, "--resume", journal, "--machine", coarse]);
        await DoneAsync([.. run, "--resume", journal, "--feed", "1200", "--journal", _folder.PathOf("second.jsonl")]);
    }

    /// <summary>Regression: the rest could be cut twice, because the journal did not record that it was cut.</summary>
    [Fact]
    public async Task A_journal_that_cannot_be_told_that_its_job_goes_on_is_refused_and_its_copy_is_taken()
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--journal", _folder.PathOf("second.jsonl")];
        await StoppedAsync(60, [.. run[..^1], journal]);
        using (var medium = new UnwritableFile(_folder.PathOf("medium.jsonl"), await File.ReadAllLinesAsync(journal)))
        {
            await RefusedAsync("cannot be written", [.. run, "--resume", medium.Path]);
        }

        await DoneAsync([.. run, "--resume", journal]);
    }

    /// <summary>Regression: a journal with an edited last position was accepted, and up to 27 % of the drawing was not cut. A crash leaves no end and at most
    /// an incomplete line.</summary>
    [Theory]
    [InlineData("stream", false)]
    [InlineData("calls", true)]
    [InlineData("program", true)]
    public async Task A_journal_that_was_changed_is_refused_and_half_a_line_is_none(string mode, bool hasEnd)
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("gasket"), "--connect", "sim:", "--json", "--mode", mode];
        await StoppedAsync(90, [.. run, "--journal", journal]);
        var lines = await File.ReadAllLinesAsync(journal);
        if (!hasEnd) lines = lines[..^1];
        var last = Array.FindLastIndex(lines, line => line.Contains("\"cut\":", StringComparison.Ordinal));

        await RefusedAsync($"line {last + 1} of the file was changed", Changed(lines, last, line => WithNumber(line, "cut", 5)));
        await RefusedAsync($"line {last + 1} of the file was changed", Changed(lines, last, line => WithNumber(line, "along", 900)));
        await RefusedAsync("lines are missing before line 4", Changed([.. lines[..3], .. lines[4..]], 0, line => line));
        await RefusedAsync($"line {last + 1} of the file has no checksum", Changed(lines, last, Unsealed));
        await RefusedAsync("the position in the same line", Changed([.. lines.Select(Unsealed)], last, line => WithNumber(line, "cut", 8)));

        string[] Changed(string[] all, int at, Func<string, string> change) => [.. run, "--resume", _folder.WithFile("changed.jsonl", string.Join('\n', all.Select((line, i) => i == at ? change(line) : line)) + "\n")];
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_journal_without_check_sums_is_taken_with_a_warning_and_a_torn_line_without(bool isOld)
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("gasket"), "--connect", "sim:", "--json"];
        await StoppedAsync(90, [.. run, "--journal", journal]);
        var lines = (await File.ReadAllLinesAsync(journal))[..^1];
        var kept = _folder.WithFile("kept.jsonl", string.Join('\n', isOld ? lines.Select(Unsealed) : [.. lines[..^1], lines[^1][..40]]));

        var told = await CliRun.RunAsync([.. run, "--resume", kept, "--journal", _folder.PathOf("second.jsonl")]);

        Assert.Equal((0, "complete", 0.0), (told.ExitCode, Text(told, "outcome"), JsonText.Of(told).GetProperty("missingLength").GetDouble()));
        Assert.Equal(isOld, told.Error.Contains("JOB0048", StringComparison.Ordinal));
        await RefusedAsync("already resumed", [.. run, "--resume", kept]); // Which was reported after the incomplete line.
    }

    private static string WithNumber(string line, string name, int more)
    {
        var found = Regex.Match(line, $"\"{name}\":(-?[0-9.]+)");
        Assert.True(found.Success, line);
        return line.Replace(found.Value, string.Create(CultureInfo.InvariantCulture, $"\"{name}\":{double.Parse(found.Groups[1].Value, CultureInfo.InvariantCulture) + more}"), StringComparison.Ordinal);
    }

    private static string Unsealed(string line) => Regex.Replace(line, ",\"n\":[0-9]+,\"sum\":\"[0-9a-f]{8}\"}$", "}");

    [Theory]
    [InlineData("-1")]
    [InlineData("long")]
    public async Task A_lead_in_that_is_none_is_a_usage_error(string length)
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--resume", "x", "--lead-in", length);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains("--lead-in", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Regression: after an intermediate dry run the start position of the job was lost, the rest was cut with an offset of 33 mm and reported as
    /// complete, and the rest could be cut repeatedly.</summary>
    [Fact]
    public async Task A_job_goes_on_once_and_nowhere_else_whatever_was_run_in_between()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var address = $"tcp://127.0.0.1:{(await controller.ListenTcpAsync(0, CancellationToken.None)).Port}?clock={(await controller.ListenClockAsync(CancellationToken.None)).Port}";
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--json"], resume = [.. run, "--resume", journal, "--journal", _folder.PathOf("second.jsonl")];
        await DoneAsync("zero", "--connect", address);
        Assert.Equal(5, (await StoppedAsync(60, [.. run, "--journal", journal])).ExitCode);
        await DoneAsync("origin", "G54", "--at", "33,0", "--connect", address);
        await RefusedAsync("33,0", resume);
        await DoneAsync([.. run, "--resume", journal, "--journal", _folder.PathOf("dry.jsonl"), "--origin", "work", "--dry-run"]);

        await RefusedAsync("33,0", resume);
        await RefusedAsync("another position", [.. resume, "--origin", "20,0"]);
        await RefusedAsync("another position", [.. resume, "--origin", "1e12,0"]);
        await RefusedAsync("another position", [.. resume, "--origin", "here"]);
        await DoneAsync("origin", "G54", "--at", "0,0", "--connect", address);
        await DoneAsync(resume);
        await RefusedAsync("already resumed", resume);
        var cut = controller.Record.Snapshot().Where(row => (row.Outputs & 1) != 0).ToList();
        Assert.Equal((50_000, 150_000), (cut.Min(row => row.A), cut.Max(row => row.A)));
    }

    public void Dispose() => _folder.Dispose();

    private static async Task DoneAsync(params string[] words)
    {
        var done = await CliRun.RunAsync(words);
        Assert.True(done.ExitCode == ExitCode.Done, $"{string.Join(' ', words)}: {done.Error}");
    }

    private static async Task RefusedAsync(string reason, params string[] words)
    {
        var refused = await CliRun.RunAsync(words);
        Assert.True(refused.ExitCode == ExitCode.Usage, $"{string.Join(' ', words)}: {refused.Out}{refused.Error}");
        Assert.Contains("JOB0040", refused.Error, StringComparison.Ordinal);
        Assert.Contains(reason, refused.Error, StringComparison.Ordinal);
    }

    private static string? Text(CliRun run, string name) => JsonText.Of(run).GetProperty(name).GetString();

    /// <summary>Ctrl-C at a progress report of the job.</summary>
    internal static async Task<CliRun> StoppedAsync(int report, params string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        using var stop = new CancellationTokenSource();
        int code;
        using (var streams = new ConsoleStreams(output, error)
        {
            Keys = () =>
            {
                if (report-- == 0) stop.Cancel();
                return null;
            },
        })
        {
            code = await EngraverProgram.RunAsync(args, streams, stop.Token);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }
}
