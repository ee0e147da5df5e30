using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The marks of a plate are engraved in two passes, of which the last one is cut three times with a stop before each repeat, then the holes with
/// another tool.</summary>
public sealed class OperatorStopRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string[] _job;

    public OperatorStopRunTests()
    {
        var operations = _folder.WithFile("repeats.json", """
            { "version": "1.0",
              "tools": [{"number": 1, "name": "Engraver", "diameter": 0.2, "feed": 900, "plunge": 300}, {"number": 3, "name": "Drill", "diameter": 3, "plunge": 120}],
              "operations": [
                { "id": "a", "name": "Marks", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.4, "depthPerPass": 0.2, "repeats": 3, "stopBetween": true },
                { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
            """);
        _job = [SampleDrawing.PathOf("operation-plate"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", operations];
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>The record of the simulated controller shows where the tool was, by no code of the program: two strokes below the work for each pass of the two
    /// marks, at rest at the start point between two runs.</summary>
    [Fact]
    public async Task Each_run_ends_before_a_repeat_and_the_record_has_every_pass_once()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var (end, clock) = (await controller.ListenTcpAsync(0, limit.Token), await controller.ListenClockAsync(limit.Token));
        var address = FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}");
        string[] run = ["run", .. _job, "--connect", address, "--json", "--tool-change", "stop"];
        await DoneAsync(["origin", "G54", "--at", "0,0,0", "--connect", address, "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json")]);

        var runs = new List<(string Outcome, int? Repeat, string Cuts, long X, long Y)>();
        for (var number = 1; number <= 4; number++)
        {
            var from = controller.Record.Snapshot().Count;
            string[] resumed = number == 1 ? [] : ["--resume", Journal(number - 1)];
            var done = await DoneAsync([.. run, .. resumed, "--journal", Journal(number)]);
            var report = JsonText.Of(done);
            var section = report.GetProperty("sections")[0];
            runs.Add((report.GetProperty("outcome").GetString()!, section.TryGetProperty("repeat", out var repeat) ? repeat.GetInt32() : null, Cuts(controller, from), report.GetProperty("finalX").GetInt64(), report.GetProperty("finalY").GetInt64()));
            Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
            if (number == 1) Assert.Contains("Next: Repeat 2 of 3 of Marks", done.Error, StringComparison.Ordinal);
        }

        Assert.Equal(("operatorStop", null, "2 -0.2, 2 -0.4", 0L, 0L), runs[0]);
        Assert.Equal(("operatorStop", 2, "2 -0.4", 0L, 0L), runs[1]);
        Assert.Equal(("toolChange", 3, "2 -0.4", 0L, 0L), runs[2]);
        Assert.Equal(("complete", null, "4 -1"), (runs[3].Outcome, runs[3].Repeat, runs[3].Cuts));
        Assert.Contains("already resumed", (await CliRun.RunAsync([.. run, "--resume", Journal(1)])).Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Asked_the_run_names_the_next_repeat_and_continues()
    {
        var run = await CliRun.Typing("\n\n\n", ["run", .. _job, "--connect", "sim:", "--json", "--tool-change", "ask", "--journal", Journal(1)]);
        var report = JsonText.Of(run);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Contains("Repeat 2 of 3 of Marks: check the work and press Enter", run.Error, StringComparison.Ordinal);
        Assert.Contains("Repeat 3 of 3 of Marks: check the work and press Enter", run.Error, StringComparison.Ordinal);
        Assert.Equal(["operatorStop", "operatorStop", "toolChange", "complete"], report.GetProperty("sections").EnumerateArray().Select(one => one.GetProperty("outcome").GetString()));
        var measured = report.GetProperty("operations")[0].GetProperty("measured");
        Assert.Equal([0.2, 0.4, 0.4, 0.4], measured.GetProperty("depths").EnumerateArray().Select(depth => Math.Round(depth.GetDouble(), 2)));
        Assert.InRange(measured.GetProperty("maxDeviation").GetDouble() + measured.GetProperty("missingLength").GetDouble() + measured.GetProperty("extraLength").GetDouble(), 0.0, 0.005);
    }

    /// <summary>Stopped in the first repeat, the job is resumed there and stops before the next one; a dry run does not stop.</summary>
    [Fact]
    public async Task An_interrupted_repeat_is_resumed_within_it()
    {
        string[] run = ["run", .. _job, "--connect", "sim:", "--json"];
        var first = JsonText.Of(await DoneAsync([.. run, "--journal", Journal(1)]));
        var stopped = await ResumeRunTests.StoppedAsync(60, [.. run, "--resume", Journal(1), "--journal", Journal(2)]);
        var second = JsonText.Of(await DoneAsync([.. run, "--resume", Journal(2), "--journal", Journal(3)]));

        Assert.Equal((ExitCode.StoppedByOperator, "operatorStop"), (stopped.ExitCode, second.GetProperty("outcome").GetString()));
        Assert.True(second.GetProperty("resumedFrom").GetProperty("segments").GetInt32() >= first.GetProperty("segmentsExecuted").GetInt32());
        Assert.Equal((0.0, 2), (second.GetProperty("missingLength").GetDouble(), second.GetProperty("sections")[0].GetProperty("repeat").GetInt32()));
        Assert.Equal("complete", JsonText.Of(await DoneAsync([.. run, "--dry-run"])).GetProperty("outcome").GetString());
    }

    [Fact]
    public async Task The_plan_has_a_section_for_every_repeat_and_verify_one_for_every_program()
    {
        var plan = JsonText.Of(await DoneAsync(["plan", .. _job, "--json"]));
        await DoneAsync(["post", .. _job, "--target", "galil", "-o", _folder.PathOf("p.dmc")]);
        var verified = await CliRun.RunAsync(["verify", _folder.PathOf("p-T1-2.dmc"), "--against", .. _job, "--section", "2"]);

        Assert.Equal(["4 -", "2 2", "2 3", "4 -"], plan.GetProperty("sections").EnumerateArray().Select(one => $"{one.GetProperty("strokes")} {(one.TryGetProperty("repeat", out var repeat) ? repeat : "-")}"));
        Assert.True(verified.ExitCode == ExitCode.Done, verified.Error);
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync(["verify", _folder.PathOf("p-T1-2.dmc"), "--against", .. _job, "--section", "0"])).ExitCode);
        Assert.Equal(["p-T1-1.dmc", "p-T1-2.dmc", "p-T1-3.dmc", "p-T3.dmc"], Directory.GetFiles(_folder.PathOf("."), "*.dmc").Select(Path.GetFileName).Order(StringComparer.Ordinal));
    }

    private string Journal(int number) => _folder.PathOf(FormattableString.Invariant($"{number}.jsonl"));

    private static async Task<CliRun> DoneAsync(params string[] words)
    {
        var done = await CliRun.RunAsync(words);
        Assert.True(done.ExitCode == ExitCode.Done, $"{string.Join(' ', words)}: {done.Error}");
        return done;
    }

    /// <summary>Number of times that the tool was in the work, by their greatest depth in millimetres, from a row of the record on.</summary>
    private static string Cuts(SimulatedController controller, int from)
    {
        var (cuts, lowest) = (new List<double>(), 0.0);
        foreach (var height in controller.Record.Snapshot().Skip(from).Select(row => row.C / 800.0))
        {
            if (height < 0.0) lowest = Math.Min(lowest, height);
            else if (lowest < 0.0)
            {
                cuts.Add(Math.Round(lowest, 2));
                lowest = 0.0;
            }
        }

        return string.Join(", ", cuts.GroupBy(depth => depth).Select(group => FormattableString.Invariant($"{group.Count()} {group.Key:0.##}")));
    }
}
