using Engraver.TestKit;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Cli.Tests.Runs;

/// <summary>What operations take besides the curves of layers, from a file to the judged run: points, insertion points, dashes and hatches.</summary>
public sealed class OperationContentRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Points_blocks_dashes_and_hatches_are_run_and_judged()
    {
        File.WriteAllBytes(_folder.PathOf("a.dxf"), Of([.. Line("HIDDEN", 0, 0, 40, 0), .. Insert("HOLE", 10, 10), .. Insert("MARK", 30, 10), (0, "POINT"), (8, "0"), (10, 20.0), (20, 10.0),
            (0, "SOLID"), (8, "HIDDEN"), (10, 0.0), (20, 20.0), (11, 10.0), (21, 20.0), (12, 0.0), (22, 30.0), (13, 10.0), (23, 30.0)]).ToAscii());
        File.WriteAllText(_folder.PathOf("o.json"), """
            { "version": "1.0", "tools": [{"number": 1, "diameter": 1, "plunge": 100}], "operations": [
              { "id": "d", "kind": "drill", "select": {"blocks": ["HOLE"], "layers": ["0"]}, "tool": 1, "depth": 1 },
              { "id": "e", "kind": "engrave", "select": {"linetypes": ["DASHED"]}, "tool": 1, "depth": 0.2, "dashes": true },
              { "id": "f", "kind": "fill", "select": {"layers": ["HIDDEN"]}, "tool": 1, "depth": 0.2, "spacing": 2, "hatches": true } ] }
            """);
        string[] job = [_folder.PathOf("a.dxf"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", _folder.PathOf("o.json"), "--json"];

        var report = JsonText.Of(await CliRun.RunAsync(["run", .. job, "--connect", "sim:", "--journal", _folder.PathOf("j.jsonl")]));
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", .. job]));

        Assert.Equal(("complete", 0.0), (report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble()));
        Assert.Equal(["d 3", "e 3", "f 5"], plan.GetProperty("operations").EnumerateArray().Select(one => $"{one.GetProperty("id").GetString()} {one.GetProperty("strokes").GetInt32()}"));
        Assert.Equal(28.0, plan.GetProperty("operations")[1].GetProperty("length").GetDouble(), 6); // 40 mm without two gaps of 6 mm
        Assert.Empty(plan.GetProperty("notCut").EnumerateObject());
    }

    /// <summary>Lines by layer, by block, with their own weight and with the default, and a letter: each width is engraved at its own depth.</summary>
    [Fact]
    public async Task Grooves_are_as_deep_as_the_lineweights_require()
    {
        File.WriteAllBytes(_folder.PathOf("w.dxf"), LineweightDrawing.Of([.. LineweightDrawing.Line("THICK", 0), .. LineweightDrawing.Line("0", 2), .. LineweightDrawing.Line("0", 4, (370, 35)), .. LineweightDrawing.Insert("OUTER", "THICK"),
            (0, "TEXT"), (8, "0"), (370, 35), (10, 0.0), (20, 10.0), (40, 5.0), (1, "I")]).ToAscii());
        File.WriteAllText(_folder.PathOf("w.json"), """
            { "version": "1.0", "tools": [{"number": 1, "kind": "engraver", "diameter": 3, "angle": 90, "plunge": 100}], "operations": [
              { "id": "v", "kind": "engrave", "select": "rest", "tool": 1, "depth": "lineWidth" } ] }
            """);
        string[] job = [_folder.PathOf("w.dxf"), "--cut", "text", "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", _folder.PathOf("w.json"), "--json"];

        var run = await CliRun.RunAsync(["run", .. job, "--connect", "sim:", "--journal", _folder.PathOf("w.jsonl")]);
        var report = JsonText.Of(run);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(("complete", 0.0), (report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble()));
        Assert.Equal(["v@0.25 1 0.125", "v@0.35 2 0.175", "v@0.5 3 0.25", "v@0.7 1 0.35"], report.GetProperty("operations").EnumerateArray().Select(one => FormattableString.Invariant($"{one.GetProperty("id").GetString()} {one.GetProperty("curves").GetInt32()} {one.GetProperty("depth").GetDouble()}")));
        Assert.All(report.GetProperty("operations").EnumerateArray(), one => Assert.Equal(one.GetProperty("depth").GetDouble(), Assert.Single(one.GetProperty("measured").GetProperty("depths").EnumerateArray()).GetDouble(), 0.0015));
    }

    [Theory]
    [InlineData("run")]
    [InlineData("plan")]
    public async Task The_power_of_a_beam_is_refused_before_anything_moves_and_only_by_a_run(string verb)
    {
        File.WriteAllText(_folder.PathOf("p.json"), """{ "version": "1.0", "tools": [{"number": 1, "diameter": 0.2}], "operations": [{ "id": "mark", "kind": "engrave", "select": "rest", "tool": 1, "power": 40 }] }""");
        string[] run = verb == "run" ? ["--connect", "sim:", "--journal", _folder.PathOf("p.jsonl"), "--accept-errors"] : [];

        var done = await CliRun.RunAsync([verb, SampleDrawing.PathOf("gasket"), "--operations", _folder.PathOf("p.json"), "--json", .. run]);

        Assert.Equal((verb == "run", verb == "run" ? ExitCode.DrawingError : ExitCode.Done), (done.Error.Contains("OPR0037", StringComparison.Ordinal), done.ExitCode));
        Assert.Equal(verb == "run" ? "refused" : "40", verb == "run" ? JsonText.Of(done).GetProperty("outcome").GetString() : JsonText.Of(done).GetProperty("operations")[0].GetProperty("power").ToString());
        Assert.False(File.Exists(_folder.PathOf("p.jsonl")));
    }
}
