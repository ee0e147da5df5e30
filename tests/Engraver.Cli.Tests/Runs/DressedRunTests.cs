using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Ramps, tabs, leads and overcuts as the motors make them. The record is compared with the dimensions of the plate, without any code of the
/// program.</summary>
public sealed class DressedRunTests : IDisposable
{
    private const double Slope = 0.1405; // 8 degrees

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("sloped")]
    [InlineData("square")]
    public async Task The_tool_descends_at_the_angle_rises_over_tabs_and_cuts_the_whole_contour(string tabs)
    {
        var operations = Operations(tabs);
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await controller.ListenTcpAsync(0, limit.Token);
        var clock = await controller.ListenClockAsync(limit.Token);
        var run = await CliRun.RunAsync(["run", SampleDrawing.PathOf("operation-plate"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", operations, "--json", "--journal", _folder.PathOf("a.jsonl"), "--connect", FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}")]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(("complete", 0.0), (JsonText.Of(run).GetProperty("outcome").GetString(), Math.Round(JsonText.Of(run).GetProperty("missingLength").GetDouble(), 9)));
        var (anchor, overTab, isRamped) = ((X: 0.0, Y: 0.0, Z: 9.0), -9.0, false);
        foreach (var row in controller.Record.Snapshot())
        {
            var (x, y, z) = (row.A / 1000.0, row.B / 1000.0, row.C / 800.0);
            Assert.InRange(z, -2.002, 100.0);
            var isAtTab = y < -1.0 && Math.Abs(x - 45.0) < 3.45; // 4 mm and the tool, without 0.05 mm
            if (isAtTab) Assert.True(z > -1.21, $"{x} {z} cuts the tab");
            if (isAtTab && z < 0.0) overTab = Math.Max(overTab, z);
            if (z > 0.0 || anchor.Z > 0.0) anchor = (x, y, z);
            var way = double.Hypot(x - anchor.X, y - anchor.Y);
            if (way < 0.0005) anchor = (x, y, z); // straight down
            if (way < 0.1) continue;
            if (y > 0.0) Assert.True(anchor.Z - z <= (Slope * way) + 0.003, $"{x} {y} {z}: steeper"); // two counts of the height
            isRamped |= y > 0.0 && anchor.Z - z > 0.01;
            anchor = (x, y, z);
        }

        Assert.True(isRamped && overTab is > -1.25 and < -0.9, $"{overTab}");
    }

    /// <summary>In the ramp of a window of 24 mm, and on the outline.</summary>
    [Theory]
    [InlineData(40)]
    [InlineData(300)]
    public async Task A_run_that_was_stopped_is_resumed_and_nothing_is_missing(int report)
    {
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("operation-plate"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--operations", Operations("sloped"), "--connect", "sim:", "--json"];
        Assert.Equal(ExitCode.StoppedByOperator, (await ResumeRunTests.StoppedAsync(report, [.. run, "--journal", journal])).ExitCode);

        var second = await CliRun.RunAsync([.. run, "--resume", journal, "--journal", _folder.PathOf("second.jsonl")]);
        Assert.True(second.ExitCode == ExitCode.Done, second.Error);
        Assert.Equal(0.0, JsonText.Of(second).GetProperty("missingLength").GetDouble());
    }

    private string Operations(string tabs) => _folder.WithFile("a.json", $$"""
            { "version": "1.0", "tools": [{"number": 1, "diameter": 3}], "operations": [{ "id": "a", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "feed": 900, "plunge": 60, "depth": 2, "depthPerPass": 1, "direction": "climb",
              "start": {"at": [[45, 60]]}, "ramp": {"angle": 8}, "overcut": 5, "leadIn": {"shape": "line", "length": 2}, "leadOut": {"shape": "arc", "radius": 2}, "tabs": {"at": [[45, 0]], "width": 4, "height": 0.8, "shape": "{{tabs}}"} }] }
            """);
}
