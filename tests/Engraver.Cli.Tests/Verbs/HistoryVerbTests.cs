using System.Text.Json;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Each test uses a separate drawing, because all write to one index.</summary>
public class HistoryVerbTests
{
    [Fact]
    public async Task Every_run_and_every_program_is_in_it_with_every_field()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("history-own.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        var run = JsonText.Of(await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--json", "--max-error", "0.005", "--journal", folder.PathOf("a.jsonl")));
        await CliRun.RunAsync("post", drawing, "--target", "agie", "-o", folder.PathOf("job.txt"));
        await CliRun.RunAsync("run", drawing, "--connect", "tcp://127.0.0.1:1", "--journal", folder.PathOf("b.jsonl"));
        var listed = await CliRun.RunAsync("history", "--json", "--search", drawing);
        var entries = JsonText.Of(listed).GetProperty("entries").EnumerateArray().ToList();

        Assert.Equal((ExitCode.Done, ""), (listed.ExitCode, listed.Error));
        Assert.Equal(["entries", "findings"], JsonText.Of(listed).EnumerateObject().Select(field => field.Name));
        Assert.Equal(
            ["id", "date", "kind", "drawing", "drawingSha256", "target", "mode", "address", "outcome", "sentence", "seconds", "plannedSeconds", "maxDeviation", "missingLength", "openLoop", "journal", "program", "report", "settings", "options", "readBack", "plate", "fonts", "cornerDeviation"],
            entries[0].EnumerateObject().Select(field => field.Name));
        Assert.Equal(["linkLost", "written", "complete"], entries.Select(entry => Word(entry, "outcome")));
        Assert.Equal((drawing, "run", "stream", "galil", folder.PathOf("a.jsonl")), (Word(entries[2], "drawing"), Word(entries[2], "kind"), Word(entries[2], "mode"), Word(entries[2], "target"), Word(entries[2], "journal")));
        Assert.Equal(["tcp://127.0.0.1:1", null, "sim:"], entries.Select(entry => Word(entry, "address")));
        Assert.Equal(run.GetProperty("seconds").GetDouble(), entries[2].GetProperty("seconds").GetDouble());
        Assert.Equal(run.GetProperty("maxDeviation").GetDouble(), entries[2].GetProperty("maxDeviation").GetDouble());
        Assert.Equal("0.005", Word(entries[2].GetProperty("settings"), "max-error"));
        Assert.Equal(("post", "agie", folder.PathOf("job.txt")), (Word(entries[1], "kind"), Word(entries[1], "target"), Word(entries[1], "program")));
    }

    [Fact]
    public async Task The_last_ones_are_lines_with_their_numbers()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("history-lines.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        foreach (var target in new[] { "galil", "cldata" }) await CliRun.RunAsync("post", drawing, "--target", target, "-o", folder.PathOf(target));
        var all = await CliRun.RunAsync("history", "--search", "HISTORY-LINES");
        var last = await CliRun.RunAsync("history", "--search", "history-lines", "--last", "1");
        var bad = await CliRun.RunAsync("history", "--last", "0");

        Assert.Equal(3, all.Out.TrimEnd().Split('\n').Length);
        var lines = last.Out.TrimEnd().Split('\n');
        Assert.EndsWith("history-lines.dxf  post cldata  written", lines[0], StringComparison.Ordinal);
        Assert.Matches("^Files of the runs: [0-9.]+ MB of at most [0-9]+ MB \\(--budget\\)$", Assert.Single(lines[1..]));
        Assert.Equal(ExitCode.Usage, bad.ExitCode);
    }

    [Fact]
    public async Task The_budget_of_the_runs_is_set_and_told()
    {
        var set = await CliRun.RunAsync("history", "--budget", "750");
        var told = await CliRun.RunAsync("history");
        var back = await CliRun.RunAsync("history", "--budget", "1000");
        var none = await CliRun.RunAsync("history", "--budget", "0");

        Assert.All([set, told], run => Assert.EndsWith(" MB of at most 750 MB (--budget)", run.Out.TrimEnd(), StringComparison.Ordinal));
        Assert.EndsWith(" MB of at most 1000 MB (--budget)", back.Out.TrimEnd(), StringComparison.Ordinal);
        Assert.Equal(ExitCode.Usage, none.ExitCode);
    }

    private static string? Word(JsonElement entry, string field) => entry.GetProperty(field).GetString();

    /// <summary>Regression: the dialect and the read-back result of a program were missing.</summary>
    [Fact]
    public async Task What_was_chosen_for_a_program_and_how_it_was_read_back_stand_with_it_and_are_found()
    {
        using var folder = new TemporaryFolder();
        var (drawing, program) = (SampleDrawing.PathOf("paper-001"), folder.PathOf("histories-of-grbl.ngc"));
        await CliRun.RunAsync("post", drawing, "--target", "gcode", "--dialect", "grbl", "--work-offset", "G57", "-o", program);
        await CliRun.RunAsync("verify", program, "--against", drawing, "--work-offset", "G57");
        var verified = await CliRun.RunAsync("history", "--search", "work-offset G57");
        var certify = await CliRun.RunAsync("certify", drawing, "--target", "gcode", "--dialect", "grbl", "--program", program, "--work-offset", "G57", "-o", folder.PathOf("c.json"));
        var certified = JsonText.Of(await CliRun.RunAsync("history", "--search", "dialect grbl", "--json")).GetProperty("entries").EnumerateArray().First(entry => entry.GetProperty("program").GetString() == program);

        Assert.Contains("post gcode dialect=grbl work-offset=G57  written  read back", verified.Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, certify.ExitCode);
        Assert.Equal(("grbl", true, folder.PathOf("c.json")), (certified.GetProperty("options").GetProperty("dialect").GetString(), certified.GetProperty("readBack").GetProperty("ok").GetBoolean(), certified.GetProperty("readBack").GetProperty("certificate").GetString()));
    }
}
