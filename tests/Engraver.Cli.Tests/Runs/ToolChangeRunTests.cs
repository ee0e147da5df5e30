using System.Text.Json;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Marks with tool 1, holes with tool 3, and the marks again, deeper, with tool 1: three sections.</summary>
public sealed class ToolChangeRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string[] _job;

    public ToolChangeRunTests()
    {
        var operations = _folder.WithFile("three.json", """
            { "version": "1.0",
              "tools": [{"number": 1, "name": "Engraver", "diameter": 0.2, "feed": 900, "plunge": 300}, {"number": 3, "name": "Drill", "diameter": 3, "plunge": 120}],
              "operations": [
                { "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.2 },
                { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1, "peck": 0.5 },
                { "id": "c", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.4 }] }
            """);
        _job = [SampleDrawing.PathOf("operation-plate"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", operations];
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>The top of the work is at another height with each tool; the record shows where the tool was, by no code of the program.</summary>
    [Fact]
    public async Task Every_section_is_cut_below_the_height_that_was_set_with_its_tool_and_at_no_other_place()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var (end, clock) = (await controller.ListenTcpAsync(0, limit.Token), await controller.ListenClockAsync(limit.Token));
        var address = FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}");
        string[] machine = ["--connect", address, "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json")];
        string[] run = ["run", .. _job, "--connect", address, "--json"];

        await DoneAsync(["origin", "G54", "--at", "0,0,0", .. machine]);
        var first = JsonText.Of(await DoneAsync([.. run, "--journal", _folder.PathOf("1.jsonl")]));
        Assert.Equal(("toolChange", 0L, 0L), (first.GetProperty("outcome").GetString(), first.GetProperty("finalX").GetInt64(), first.GetProperty("finalY").GetInt64()));
        Assert.Equal(-0.2, Deepest(controller, 0), 2);

        await DoneAsync(["origin", "G54", "--at", "5,0,0.5", .. machine]);
        var elsewhere = await CliRun.RunAsync([.. run, "--resume", _folder.PathOf("1.jsonl")]);
        Assert.Equal(ExitCode.Usage, elsewhere.ExitCode);
        Assert.Contains("JOB0040", elsewhere.Error, StringComparison.Ordinal);

        var from = controller.Record.Snapshot().Count;
        await DoneAsync(["origin", "G54", "--at", "0,0,0.5", .. machine]);
        await DoneAsync([.. run, "--resume", _folder.PathOf("1.jsonl"), "--journal", _folder.PathOf("2.jsonl")]);
        Assert.Equal(0.5 - 1.0, Deepest(controller, from), 2);

        from = controller.Record.Snapshot().Count;
        await DoneAsync(["origin", "G54", "--at", "0,0,-0.5", .. machine]);
        var last = JsonText.Of(await DoneAsync([.. run, "--resume", _folder.PathOf("2.jsonl"), "--journal", _folder.PathOf("3.jsonl")]));
        Assert.Equal(-0.5 - 0.4, Deepest(controller, from), 2);
        Assert.Equal(("complete", 3), (last.GetProperty("outcome").GetString(), last.GetProperty("sections")[0].GetProperty("number").GetInt32()));
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task Asked_the_run_continues_and_its_figures_are_those_of_all_sections(string mode)
    {
        var run = await CliRun.Typing("\n\n", ["run", .. _job, "--connect", "sim:", "--mode", mode, "--json", "--tool-change", "ask", "--journal", _folder.PathOf("a.jsonl")]);
        var report = JsonText.Of(run);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Contains("Change to tool Drill (3)", run.Error, StringComparison.Ordinal);
        var sections = report.GetProperty("sections").EnumerateArray().ToList();
        Assert.Equal(["1 1 a toolChange a", "2 3 b toolChange a-2", "3 1 c complete a-3"], sections.Select(Line));
        Assert.Equal(("complete", 0.0, _folder.PathOf("a-3.jsonl")), (report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble(), report.GetProperty("journal").GetString()));
        Assert.Equal(sections.Max(one => one.GetProperty("maxDeviation").GetDouble()), report.GetProperty("maxDeviation").GetDouble());
        Assert.Equal(sections.Sum(one => one.GetProperty("seconds").GetDouble()), report.GetProperty("seconds").GetDouble(), 6);
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, 0.005);
        var measured = report.GetProperty("operations").EnumerateArray().Select(one => one.GetProperty("measured")).ToList();
        Assert.Equal([0.2, 1.0, 0.4], measured.Select(one => Math.Round(Assert.Single(one.GetProperty("depths").EnumerateArray()).GetDouble(), 2)));
        Assert.All(measured, one => Assert.InRange(one.GetProperty("maxDeviation").GetDouble() + one.GetProperty("missingLength").GetDouble() + one.GetProperty("extraLength").GetDouble(), 0.0, 0.005));
        Assert.InRange(measured[0].GetProperty("feed").GetDouble(), 890.0, 905.0);
        Assert.Equal(JsonValueKind.Null, measured[1].GetProperty("feed").ValueKind);
        Assert.Equal(report.GetProperty("segmentsSent").GetInt32(), report.GetProperty("segmentsExecuted").GetInt32());
    }

    /// <summary>Without an answer the run ends at the change; stopped inside of the second section, it is resumed there; what a lost host leaves at a change is
    /// named.</summary>
    [Fact]
    public async Task An_interrupted_section_is_resumed_within_it()
    {
        string[] run = ["run", .. _job, "--connect", "sim:", "--json"];
        var first = await DoneAsync([.. run, "--tool-change", "ask", "--journal", _folder.PathOf("1.jsonl")]);
        Assert.Equal("toolChange", JsonText.Of(first).GetProperty("outcome").GetString());
        Assert.Contains("--resume " + _folder.PathOf("1.jsonl"), first.Error, StringComparison.Ordinal);
        var crashed = _folder.PathOf("crashed.jsonl");
        await File.WriteAllLinesAsync(crashed, (await File.ReadAllLinesAsync(_folder.PathOf("1.jsonl"))).SkipLast(1));

        var stopped = await ResumeRunTests.StoppedAsync(120, [.. run, "--resume", _folder.PathOf("1.jsonl"), "--journal", _folder.PathOf("2.jsonl")]);
        Assert.Equal((ExitCode.StoppedByOperator, 2), (stopped.ExitCode, JsonText.Of(stopped).GetProperty("sections")[0].GetProperty("number").GetInt32()));
        var third = JsonText.Of(await DoneAsync([.. run, "--resume", _folder.PathOf("2.jsonl"), "--journal", _folder.PathOf("3.jsonl")]));
        Assert.Equal(("toolChange", 0.0, 2), (third.GetProperty("outcome").GetString(), third.GetProperty("missingLength").GetDouble(), third.GetProperty("sections")[0].GetProperty("number").GetInt32()));
        Assert.True(third.GetProperty("resumedFrom").GetProperty("segments").GetInt32() > JsonText.Of(first).GetProperty("segmentsExecuted").GetInt32());

        var unchanged = await DoneAsync([.. run, "--resume", crashed, "--journal", _folder.PathOf("4.jsonl")]);
        Assert.Contains("OPR0030", unchanged.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("OPR0030", first.Error + stopped.Error, StringComparison.Ordinal);
    }

    /// <summary>A plate ends with tool 3: the next one begins when tool 1 is in the machine again.</summary>
    [Fact]
    public async Task Every_plate_of_a_series_begins_with_its_first_tool()
    {
        var operations = _folder.WithFile("two.json", """
            { "version": "1.0", "tools": [{"number": 1, "name": "Engraver", "diameter": 0.2}, {"number": 3, "name": "Drill", "diameter": 3}], "operations": [
                { "id": "a", "kind": "engrave", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 0.2 }, { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
            """);
        string[] run = ["run", .. _job[..^1], operations, "--connect", "sim:", "--json", "--grid", "2x1", "--pitch", "100,0", "--tool-change", "ask"];

        var asked = await CliRun.Typing("\n\n\n", run);
        Assert.True(asked.ExitCode == ExitCode.Done, asked.Error);
        Assert.Contains("Plate 2 begins with tool Engraver (1)", asked.Error, StringComparison.Ordinal);
        Assert.Equal(["complete", "complete"], JsonText.Of(asked).GetProperty("plates").EnumerateArray().Select(plate => plate.GetProperty("outcome").GetString()));

        var ended = await CliRun.Typing("\n", run);
        Assert.Equal((ExitCode.Done, "toolChange"), (ended.ExitCode, JsonText.Of(ended).GetProperty("outcome").GetString()));
        Assert.Equal("complete", Assert.Single(JsonText.Of(ended).GetProperty("plates").EnumerateArray()).GetProperty("outcome").GetString());
        Assert.Contains("--first-cell 2", ended.Error, StringComparison.Ordinal);

        using var stop = new CancellationTokenSource();
        using var input = new StoppingReader(stop, answers: 1);
        var stopped = await CliRun.Typing(input, stop.Token, run);
        Assert.Equal(ExitCode.StoppedByOperator, stopped.ExitCode);
        Assert.Contains("Plate 2 begins with tool Engraver (1)", stopped.Error, StringComparison.Ordinal);
        Assert.Contains("--first-cell 2", stopped.Error, StringComparison.Ordinal);
    }

    /// <summary>The second plate has no text: it begins with the drill, which is still in the machine, and the third with the engraver again.</summary>
    [Fact]
    public async Task A_plate_is_asked_for_its_own_first_tool()
    {
        var drawing = _folder.WithFile("plates.dxf", System.Text.Encoding.ASCII.GetString(DxfText.WithEntities((0, "TEXT"), (8, "T"), (10, 0.0), (20, 5.0), (40, 3.0), (1, "[[csv:name?]]"), (0, "CIRCLE"), (8, "HOLES"), (10, 2.0), (20, 2.0), (40, 1.0)).ToAscii()));
        var operations = _folder.WithFile("text.json", """
            { "version": "1.0", "tools": [{"number": 1, "name": "Engraver", "diameter": 0.2}, {"number": 3, "name": "Drill", "diameter": 2}], "operations": [
                { "id": "a", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.2 }, { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
            """);
        var run = await CliRun.Typing("\n\n\n", ["run", drawing, "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--cut", "text", "--operations", operations, "--csv", _folder.WithFile("rows.csv", "name,size\nA,1\n,2\nC,3\n"), "--grid", "3x1", "--pitch", "30,0", "--connect", "sim:", "--json", "--tool-change", "ask"]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(3, JsonText.Of(run).GetProperty("plates").GetArrayLength());
        Assert.Equal(["Plate 3 begins with tool Engraver (1)"], run.Error.Split('\n').Where(line => line.Contains("begins with tool", StringComparison.Ordinal)).Select(line => line[..line.IndexOf('.', StringComparison.Ordinal)]));
        Assert.Equal(2, run.Error.Split("Change to tool Drill (3)").Length - 1);
    }

    [Fact]
    public async Task The_plan_has_a_time_for_every_section_and_a_program_for_one_tool_is_refused()
    {
        var plan = JsonText.Of(await DoneAsync(["plan", .. _job, "--json"]));
        var one = JsonText.Of(await DoneAsync(["plan", .. _job, "--json", "--tool-number", "3"]));
        var post = await CliRun.RunAsync(["post", .. _job, "--target", "galil"]);

        var sections = plan.GetProperty("sections").EnumerateArray().ToList();
        Assert.Equal([(1, 2), (3, 4), (1, 2)], sections.Select(section => (section.GetProperty("tool").GetInt32(), section.GetProperty("strokes").GetInt32())));
        Assert.Equal(one.GetProperty("seconds").GetProperty("total").GetDouble(), sections[1].GetProperty("seconds").GetDouble(), 1);
        Assert.Equal([300.0, 120.0, 300.0], plan.GetProperty("operations").EnumerateArray().Select(operation => operation.GetProperty("plunge").GetDouble()));
        Assert.False(one.TryGetProperty("sections", out _));
        Assert.Equal(ExitCode.DrawingError, post.ExitCode);
        Assert.Contains("OPR0012", post.Error, StringComparison.Ordinal);
    }

    private static string Line(JsonElement section) =>
        $"{section.GetProperty("number")} {section.GetProperty("tool")} {section.GetProperty("operations")[0]} {section.GetProperty("outcome")} {Path.GetFileNameWithoutExtension(section.GetProperty("journal").GetString())}";

    private static async Task<CliRun> DoneAsync(params string[] words)
    {
        var done = await CliRun.RunAsync(words);
        Assert.True(done.ExitCode == ExitCode.Done, $"{string.Join(' ', words)}: {done.Error}");
        return done;
    }

    /// <summary>Lowest height in millimetres from a row of the record on.</summary>
    private static double Deepest(SimulatedController controller, int from) => controller.Record.Snapshot().Skip(from).Min(row => row.C) / 800.0;
}
