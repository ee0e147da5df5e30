namespace Engraver.Cli.Tests.Verbs;

public class ReplayVerbTests
{
    [Fact]
    public async Task A_run_is_replayed_from_its_journal_and_held_against_a_record()
    {
        using var folder = new TemporaryFolder();
        var run = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--journal", folder.PathOf("a.jsonl")));
        var replay = await CliRun.RunAsync("replay", folder.PathOf("a.jsonl"), "--record", folder.PathOf("a.csv"), "--json");
        var again = await CliRun.RunAsync("replay", folder.PathOf("a.jsonl"), "--against", folder.PathOf("a.csv"), "--json");
        var rows = await File.ReadAllLinesAsync(folder.PathOf("a.csv"));
        await File.WriteAllLinesAsync(folder.PathOf("b.csv"), [.. rows.Take(100), "other", .. rows.Skip(101)]);
        var other = await CliRun.RunAsync("replay", folder.PathOf("a.jsonl"), "--against", folder.PathOf("b.csv"));

        Assert.Equal((ExitCode.Done, ExitCode.Done, ExitCode.DrawingError), (replay.ExitCode, again.ExitCode, other.ExitCode));
        Assert.Equal(
            ["journal", "drawing", "outcome", "clock", "whole", "said", "samples", "seconds", "finalX", "finalY", "journalX", "journalY", "agrees", "late", "against"],
            JsonText.Of(replay).EnumerateObject().Select(field => field.Name));
        Assert.Equal((run.GetProperty("finalX").GetInt32(), run.GetProperty("finalY").GetInt32(), true), (JsonText.Of(replay).GetProperty("finalX").GetInt32(), JsonText.Of(replay).GetProperty("finalY").GetInt32(), JsonText.Of(replay).GetProperty("agrees").GetBoolean()));
        Assert.Equal(("controller", "complete", rows.Length - 1), (JsonText.Of(replay).GetProperty("clock").GetString(), JsonText.Of(replay).GetProperty("outcome").GetString(), JsonText.Of(replay).GetProperty("samples").GetInt32()));
        Assert.Equal("t,a,b,c,d,outputs", rows[0]);
        Assert.Equal(["same", "lines", "record", "replay"], JsonText.Of(again).GetProperty("against").EnumerateObject().Select(field => field.Name));
        Assert.Equal((true, rows.Length), (JsonText.Of(again).GetProperty("against").GetProperty("same").GetBoolean(), JsonText.Of(again).GetProperty("against").GetProperty("lines").GetInt32()));
        Assert.Contains("The first 100 lines are equal; then the record has 'other'", other.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("A", ExitCode.Usage, "the axes A,")]
    [InlineData("ABCD", ExitCode.Usage, "the axes ABCD,")]
    [InlineData("A?", ExitCode.Usage, "the axes A?,")]
    [InlineData("AB", ExitCode.Done, "Replayed steps: 1; nothing moved.")]
    public async Task A_damaged_journal_and_one_of_a_run_that_did_not_move_are_told(string axes, int code, string told)
    {
        using var folder = new TemporaryFolder();
        var journal = folder.WithFile("damaged.jsonl", "{\"kind\":\"job\",\"drawing\":\"a.dxf\",\"controller\":\"DMC2143\",\"mode\":\"stream\",\"segmentCount\":1,\"startX\":0,\"startY\":0,\"frameX\":0,\"frameY\":0,\"startedAt\":\"1970-01-01T00:00:00+00:00\",\"axes\":\"" + axes + "\"}\n");
        folder.WithFile("damaged.jsonl.wire", "#wire;1;controller\n0 0 +\n#end\n");
        var run = await CliRun.RunAsync("replay", journal);

        Assert.Equal(code, run.ExitCode);
        Assert.Contains(told, run.Out + run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_conversation_over_more_links_than_a_controller_has_cannot_be_replayed()
    {
        using var folder = new TemporaryFolder();
        folder.WithFile("many.jsonl.wire", "#wire;1;controller\n" + string.Concat(Enumerable.Range(0, 40).Select(link => string.Create(System.Globalization.CultureInfo.InvariantCulture, $"0 {link} +\n"))) + "#end\n");
        var run = await CliRun.RunAsync("replay", folder.WithFile("many.jsonl", ""));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("handles", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("written", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_journal_without_a_conversation_and_one_that_is_not_there_say_what_is_lacking()
    {
        using var folder = new TemporaryFolder();
        var old = await CliRun.RunAsync("replay", folder.WithFile("old.jsonl", "{\"kind\":\"job\",\"drawing\":\"a.dxf\",\"controller\":\"DMC2143\",\"mode\":\"stream\",\"segmentCount\":1,\"startX\":0,\"startY\":0,\"frameX\":0,\"frameY\":0,\"startedAt\":\"1970-01-01T00:00:00+00:00\"}\n"));
        var gone = await CliRun.RunAsync("replay", folder.PathOf("nowhere.jsonl"));

        Assert.Equal((ExitCode.Usage, ExitCode.Usage), (old.ExitCode, gone.ExitCode));
        Assert.Contains("does not contain the commands sent to the controller", old.Error, StringComparison.Ordinal);
        Assert.Contains("nowhere.jsonl", gone.Error, StringComparison.Ordinal);
    }
}
