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
}
