using System.Globalization;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The plate of the samples with its operations, from the files to the record of the motors.</summary>
public sealed class OperationRunTests : IDisposable
{
    private const double Radius = 1.5;

    private static readonly string s_operations = Path.Combine(RepositoryFolder.Samples, "operation-plate.operations.json");
    private static readonly string s_machine = Path.Combine(RepositoryFolder.Samples, "machine-mill.json");
    private static readonly string[] s_job = [SampleDrawing.PathOf("operation-plate"), "--cut", "text", "--machine", s_machine];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The record is compared with the dimensions of the plate, without any code of the program.</summary>
    [Fact]
    public async Task Every_sample_in_the_material_is_where_an_operation_is_at_its_depth()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await controller.ListenTcpAsync(0, limit.Token);
        var clock = await controller.ListenClockAsync(limit.Token);
        var run = await CliRun.RunAsync(["run", .. s_job, "--operations", s_operations, "--json", "--journal", _folder.PathOf("a.jsonl"), "--connect", FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}")]);
        var report = JsonText.Of(run);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(("complete", 0.0), (report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble()));
        var (deepest, outside) = (new Dictionary<string, double>(), new List<string>());
        foreach (var row in controller.Record.Snapshot())
        {
            var (x, y, z) = (row.A / 1000.0, row.B / 1000.0, row.C / 800.0);
            if (z >= -0.0013) continue;
            var (place, limitDepth) = PlaceOf(x, y);
            if (z < -limitDepth - 0.003) outside.Add(FormattableString.Invariant($"{x} {y} {z} {place}"));
            deepest[place] = Math.Min(deepest.GetValueOrDefault(place), z);
        }

        Assert.Empty(outside.Take(5));
        Assert.Equal(["hole", "lead", "mark", "outline", "pocket", "tab", "window"], deepest.Keys.Order(StringComparer.Ordinal));
        foreach (var (place, depth) in (ReadOnlySpan<(string, double)>)[("hole", 4.0), ("lead", 3.0), ("mark", 0.2), ("outline", 3.0), ("pocket", 2.0), ("tab", 2.0), ("window", 3.0)]) Assert.Equal(-depth, deepest[place], 2);
    }

    [Fact]
    public async Task Plan_sequence_and_notCut_name_the_operations()
    {
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", .. s_job, "--operations", s_operations, "--json"]));
        var sequence = JsonText.Of(await CliRun.RunAsync(["sequence", .. s_job, "--operations", s_operations, "--json"]));
        var without = JsonText.Of(await CliRun.RunAsync(["plan", .. s_job, "--json"]));

        var operations = plan.GetProperty("operations").EnumerateArray().ToList();
        Assert.Equal(["marks engrave", "holes drill", "pocket pocket", "outline profile"], operations.Select(one => $"{one.GetProperty("id").GetString()} {one.GetProperty("kind").GetString()}"));
        Assert.Equal([(500.0, 120.0), (500.0, 120.0), (500.0, 120.0), (500.0, 120.0)], operations.Select(one => (one.GetProperty("feed").GetDouble(), one.GetProperty("plunge").GetDouble())));
        Assert.Equal((2, 8, 4, 3.0), (operations[3].GetProperty("curves").GetInt32(), operations[3].GetProperty("strokes").GetInt32(), operations[3].GetProperty("passes").GetInt32(), operations[3].GetProperty("depth").GetDouble()));
        var strokes = sequence.GetProperty("strokes").EnumerateArray().ToList();
        Assert.Equal(operations.Sum(one => one.GetProperty("strokes").GetInt32()), strokes.Count);
        Assert.Equal([("outline", 3, 3.0), ("outline", 2, 2.8)], strokes.AsEnumerable().Reverse().Take(2).Select(stroke => (stroke.GetProperty("operation").GetString()!, stroke.GetProperty("pass").GetInt32(), Math.Round(stroke.GetProperty("depth").GetDouble(), 6))));
        Assert.False(without.TryGetProperty("operations", out _));
        Assert.Equal(plan.GetProperty("cutLength").GetDouble(), operations.Sum(one => one.GetProperty("length").GetDouble()), 6);

        var some = await CliRun.RunAsync(["plan", .. s_job, "--operations", WithoutOperation("marks"), "--json"]);
        Assert.Contains("OPR0008", some.Error, StringComparison.Ordinal);
        Assert.Contains("take LINE, TEXT with an operation", (await CliRun.RunAsync(["run", .. s_job, "--operations", WithoutOperation("marks"), "--connect", "sim:", "--journal", _folder.PathOf("n.jsonl")])).Out, StringComparison.Ordinal);
        Assert.Equal([("LINE", 2), ("TEXT", 1)], JsonText.Of(some).GetProperty("notCut").EnumerateObject().Select(type => (type.Name, type.Value.GetInt32())));
    }

    [Theory]
    [InlineData("post", "OPR0017", 1, "--target", "agie")]
    [InlineData("post", "OPR0037", 1, "--target", "hpgl")]
    [InlineData("plan", "--kerf cannot be used with --operations", 2, "--kerf", "outside", "--tool-diameter", "3")]
    [InlineData("plan", "--enter cannot be used with --operations", 2, "--enter", "0,0")]
    [InlineData("plan", "OPR0020", 1, "--tool-number", "1")]
    [InlineData("table", "OPR0020", 1, "--tool-number", "1")]
    [InlineData("plot", "OPR0020", 1, "--tool-number", "1")]
    [InlineData("plan", "1.5 is not a tool number", 2, "--tool-number", "1.5")]
    public async Task What_operations_cannot_do_is_refused(string verb, string message, int code, params string[] words)
    {
        var refused = await CliRun.RunAsync([verb, .. s_job, "--operations", s_operations, .. words, .. verb is "post" or "plot" ? ["-o", _folder.PathOf(verb == "post" ? "a.txt" : "a.svg")] : (string[])[]]);

        Assert.Equal(code, refused.ExitCode);
        Assert.Contains(message, refused.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(_folder.PathOf("a.txt")) || File.Exists(_folder.PathOf("a.svg")));
    }

    [Fact]
    public async Task A_machine_without_a_tool_axis_runs_operations_without_depths_only()
    {
        string[] run = ["run", SampleDrawing.PathOf("operation-plate"), "--connect", "sim:", "--journal", _folder.PathOf("a.jsonl")];
        var flat = _folder.WithFile("flat.json", """{ "version": "1.0", "tools": [{"number": 1, "diameter": 0.1}], "operations": [{ "id": "a", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "feed": 300, "repeats": 2 }, { "id": "b", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1 }] }""");
        var deep = await CliRun.RunAsync([.. run, "--operations", s_operations]);
        var done = await CliRun.RunAsync([.. run, "--operations", flat, "--json"]);

        Assert.Equal(ExitCode.DrawingError, deep.ExitCode);
        Assert.Contains("OPR0010", deep.Error, StringComparison.Ordinal);
        Assert.True(done.ExitCode == ExitCode.Done, done.Error);
        Assert.Equal(4, JsonText.Of(done).GetProperty("operations")[0].GetProperty("strokes").GetInt32());
    }

    [Fact]
    public async Task Each_operation_has_its_plunge_feed_and_its_waits_in_the_program()
    {
        var operations = WithText("\"peck\": 1.5", "\"peck\": 1.5, \"plunge\": 60, \"dwell\": 0.25");
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", .. s_job, "--operations", operations, "--json"]));
        var program = _folder.PathOf("plate.dmc");
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["post", .. s_job, "--operations", operations, "--target", "galil", "-o", program])).ExitCode);

        Assert.Equal([120.0, 60.0, 120.0, 120.0], plan.GetProperty("operations").EnumerateArray().Select(one => one.GetProperty("plunge").GetDouble()));
        var lines = await File.ReadAllLinesAsync(program);
        Assert.Equal((4, 4), (lines.Count(line => line.Contains(";zf=800;", StringComparison.Ordinal)), lines.Count(line => line == "WT 250;JS#UP")));
        Assert.Equal(lines.Count(line => line.Contains("JS#DOWN", StringComparison.Ordinal)) - 4, lines.Count(line => line.Contains(";zf=1600;", StringComparison.Ordinal)));
    }

    /// <summary>A program of each tool in a file of its own, of which the JSON states the names; nothing is written where one cannot be.</summary>
    [Fact]
    public async Task Post_writes_a_Galil_program_for_each_tool()
    {
        var operations = WithText("\"select\": { \"layers\": [\"HOLES\"] }, \"tool\": 3", "\"select\": { \"layers\": [\"HOLES\"] }, \"tool\": 1");
        string[] post = ["post", .. s_job, "--operations", operations, "--target", "galil"];
        var written = await CliRun.RunAsync([.. post, "-o", _folder.PathOf("p.dmc"), "--json"]);
        var shown = JsonText.Of(await CliRun.RunAsync([.. post, "--json"])).GetProperty("programs").EnumerateArray().ToList();
        var single = await CliRun.RunAsync(post);

        Assert.True(written.ExitCode == ExitCode.Done, written.Error);
        var programs = JsonText.Of(written).GetProperty("programs").EnumerateArray().ToList();
        Assert.Equal([(3, "p-T3-1.dmc"), (1, "p-T1.dmc"), (3, "p-T3-3.dmc")], programs.Select(program => (program.GetProperty("tool").GetInt32(), Path.GetFileName(program.GetProperty("file").GetString())!)));
        foreach (var (program, text) in programs.Zip(shown)) Assert.Equal(await File.ReadAllTextAsync(program.GetProperty("file").GetString()!), text.GetProperty("text").GetString());
        Assert.False(File.Exists(_folder.PathOf("p.dmc")));
        Assert.Equal(ExitCode.DrawingError, single.ExitCode);
        Assert.Contains("OPR0012", single.Error, StringComparison.Ordinal);
    }

    /// <summary>Stopped in the marks, in a hole, in the pocket, and in the outline.</summary>
    [Theory]
    [InlineData(80)]
    [InlineData(170)]
    [InlineData(250)]
    [InlineData(600)]
    public async Task A_stopped_run_is_resumed_with_the_same_operations_only(int report)
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", .. s_job, "--connect", "sim:", "--json"];
        Assert.Equal(ExitCode.StoppedByOperator, (await ResumeRunTests.StoppedAsync(report, [.. run, "--operations", s_operations, "--journal", journal])).ExitCode);

        var other = await CliRun.RunAsync([.. run, "--operations", WithText("\"depth\": 3", "\"depth\": 3.5"), "--resume", journal]);
        Assert.Equal(ExitCode.Usage, other.ExitCode);
        Assert.Matches("Operations was SHA-256 [0-9a-f]{12}, now SHA-256 [0-9a-f]{12}", other.Error);
        var second = await CliRun.RunAsync([.. run, "--operations", s_operations, "--resume", journal, "--journal", _folder.PathOf("second.jsonl")]);
        Assert.True(second.ExitCode == ExitCode.Done, second.Error);
        Assert.Equal(0.0, JsonText.Of(second).GetProperty("missingLength").GetDouble());
    }

    /// <summary>A posted program is verified with other operations than those it was written with: each difference is found.</summary>
    [Theory]
    [InlineData("\"depth\": 3,", "\"depth\": 3.05,")]
    [InlineData("\"depthPerPass\": 1, \"stepover\"", "\"depthPerPass\": 2, \"stepover\"")]
    [InlineData("\"side\": \"nesting\"", "\"side\": \"inside\"")]
    [InlineData("\"maxDiameter\": 4", "\"maxDiameter\": 3")]
    [InlineData("\"finish\": 0.2", "\"finish\": 0.3")]
    [InlineData("\"stepover\": 0.4", "\"stepover\": 0.3")]
    public async Task Verify_finds_a_program_of_other_operations(string from, string to)
    {
        var program = _folder.PathOf("plate.dmc");
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["post", .. s_job, "--operations", s_operations, "--target", "galil", "-o", program])).ExitCode);
        string[] verify = ["verify", program, "--against", s_job[0], .. s_job[1..], "--operations"];

        var same = await CliRun.RunAsync([.. verify, s_operations, "--json"]);
        Assert.True(same.ExitCode == ExitCode.Done, same.Error);
        Assert.Equal(["marks 0.2", "holes 4", "pocket 1 2", "outline 0.93 1.87 2.8 3"], JsonText.Of(same).GetProperty("operations").EnumerateArray().Select(one => string.Join(' ', one.GetProperty("depths").EnumerateArray().Select(depth => Math.Round(depth.GetDouble(), 2).ToString(CultureInfo.InvariantCulture)).Prepend(one.GetProperty("id").GetString()))));
        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync([.. verify, WithText(from, to)])).ExitCode);
    }

    private string WithoutOperation(string id) => WithText($"\"id\": \"{id}\",", $"\"id\": \"{id}\", \"on\": false,");

    /// <summary>The operations of the plate with another text in them.</summary>
    private string WithText(string from, string to)
    {
        var text = File.ReadAllText(s_operations);
        Assert.Contains(from, text, StringComparison.Ordinal);
        File.Copy(Path.Combine(RepositoryFolder.Samples, "shop.tools.json"), _folder.PathOf("shop.tools.json"), overwrite: true);
        return _folder.WithFile("other.json", text.Replace(from, to, StringComparison.Ordinal));
    }

    /// <summary>Where the centre of the tool may be below the surface, and how deep.</summary>
    private static (string Place, double Depth) PlaceOf(double x, double y)
    {
        const double near = 0.02;
        var (fromWindow, fromOutline) = (double.Hypot(x - 68.0, y - 34.0) - (12.0 - Radius), FromRoundedRectangle(x, y, 0, 0, 90, 60, 6.0) - Radius);
        if (Math.Abs(fromOutline) < near && IsTab(x, y)) return ("tab", 2.0);
        if (Math.Abs(fromWindow) < near) return ("window", 3.0);
        if (Math.Abs(fromOutline) < near) return ("outline", 3.0);
        if (fromOutline is > 0.0 and < 2.0 + near || fromWindow is > -2.0 - near and < 0.0) return ("lead", 3.0);
        if (new[] { (7, 7), (83, 7), (83, 53), (7, 53) }.Any(hole => double.Hypot(x - hole.Item1, y - hole.Item2) < near)) return ("hole", 4.0);
        if (FromRoundedRectangle(x, y, 14, 20, 48, 48, 4.0) < -Radius + near && double.Hypot(x - 31.0, y - 34.0) > 6.0 + Radius - near) return ("pocket", 2.0);
        if (y < 19.0 && FromRoundedRectangle(x, y, 0, 0, 90, 60, 6.0) < 0.0) return ("mark", 0.2);
        return ("nothing", 0.0);
    }

    /// <summary>At a tab of the outline: two on its lower and two on its upper side, 3 mm wide and 3 mm for the tool.</summary>
    private static bool IsTab(double x, double y) => (y < 0.0 || y > 60.0) && (x is (> 7.55 and < 13.45) or (> 76.55 and < 82.45));

    /// <summary>Signed distance from a rounded rectangle, negative inside.</summary>
    private static double FromRoundedRectangle(double x, double y, double left, double bottom, double right, double top, double radius)
    {
        var (halfX, halfY) = (((right - left) / 2.0) - radius, ((top - bottom) / 2.0) - radius);
        var (dx, dy) = (Math.Abs(x - ((left + right) / 2.0)) - halfX, Math.Abs(y - ((bottom + top) / 2.0)) - halfY);
        return double.Hypot(Math.Max(dx, 0.0), Math.Max(dy, 0.0)) + Math.Min(Math.Max(dx, dy), 0.0) - radius;
    }
}
