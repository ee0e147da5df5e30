using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Copies of a plate in several fixtures, each at its own work origin; the record of the motors shows where they were cut, by no code of the
/// program.</summary>
public sealed class FixtureRunTests : IDisposable
{
    private const int Tool = 1;
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(2);

    private readonly TemporaryFolder _folder = new();
    private readonly CancellationTokenSource _limit = new(s_patience);

    public void Dispose()
    {
        _limit.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task Each_fixture_gets_its_copies_and_one_that_was_interrupted_is_resumed_there()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var address = await AddressAsync(controller);
        await OriginsAsync(address, ("G55", "100,0"), ("G57", "0,200"), ("G54", "-50,-50"));
        string[] run = ["run", Drawing(), "--cut", "text", "--fixtures", "g57,G55", "--grid", "2x1", "--pitch", "20,0", "--connect", address];

        var stopped = await InterruptedSeries.InPlateThreeAsync("Plate 3: ", stop => stop.Cancel(), run);
        Assert.True(stopped.ExitCode == ExitCode.StoppedByOperator, stopped.Error);
        Assert.Contains("Plate 3 of 4: copy=3 in G55", stopped.Error, StringComparison.Ordinal);
        var journal = Regex.Match(stopped.Error, @"--resume (\S+\.jsonl)").Groups[1].Value;
        Assert.Contains("G55", await File.ReadAllTextAsync(journal), StringComparison.Ordinal);
        var other = await CliRun.RunAsync([.. run.Select(word => word == "g57,G55" ? "G55,G57" : word), "--resume", journal]);
        Assert.True(other.ExitCode == ExitCode.Usage, other.Error);

        var resumed = await CliRun.RunAsync([.. run, "--resume", journal, "--json"]);
        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.Equal([(3, "G55", 0.0), (4, "G55", 20.0)], Plates(resumed).Select(plate => (plate.GetProperty("number").GetInt32(), plate.GetProperty("fixture").GetString()!, plate.GetProperty("x").GetDouble())));
        Assert.All(Plates(resumed), plate => Assert.Equal("complete", plate.GetProperty("outcome").GetString()));
        Assert.Equal([(0, 200_000), (20_000, 200_000), (100_000, 0), (120_000, 0)], Cells(controller));
        Assert.Equal("G54", JsonText.Of(await CliRun.RunAsync("status", "--connect", address, "--json")).GetProperty("work").GetProperty("name").GetString());
        var history = JsonText.Of(await CliRun.RunAsync("history", "--search", "copy=4 at 20,0 in G55", "--json")).GetProperty("entries");
        Assert.Contains(history.EnumerateArray(), entry => entry.GetProperty("drawing").GetString() == Drawing());
    }

    [Theory]
    [InlineData("G54,G56", ExitCode.Usage, "JOB0008", "the job cannot be cut at the work origin G56")]
    [InlineData("G54,G57", ExitCode.DrawingError, "JOB0030", "the job cannot be cut at the work origin G57")]
    [InlineData("G57,G54", ExitCode.DrawingError, "JOB0030", "the job cannot be cut at the work origin G57")]
    [InlineData("G54,G55,G58", ExitCode.Usage, "JOB0052", "the job cannot be cut at the work origin G58")]
    public async Task Nothing_moves_if_a_later_fixture_cannot_be_used(string fixtures, int code, string rule, string message)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var address = await AddressAsync(controller);
        var machine = _folder.WithFile("short.json", """{ "travelX": { "min": -1, "max": 70 }, "travelY": { "min": -1, "max": 70 } }""");
        await OriginsAsync(address, ("G54", "0,0"), ("G55", "30,0"), ("G57", "60,0"), ("G58", "30,0"));

        var run = await CliRun.RunAsync("run", Drawing(), "--cut", "text", "--fixtures", fixtures, "--machine", machine, "--connect", address, "--json");

        Assert.Equal(code, run.ExitCode);
        Assert.Contains(rule, run.Error, StringComparison.Ordinal);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(["refused"], Plates(run).Select(plate => plate.GetProperty("outcome").GetString()));
        Assert.DoesNotContain(controller.Record.Snapshot(), row => (row.A, row.B) != (0, 0));
    }

    [Fact]
    public async Task A_rehearsal_and_the_plan_name_every_fixture()
    {
        string[] series = [Drawing(), "--cut", "text", "--fixtures", "G54,G55", "--first-cell", "2"];
        var (run, plan) = (await CliRun.RunAsync(["run", .. series, "--connect", "sim:", "--json"]), await CliRun.RunAsync(["plan", Drawing(), "--cut", "text", "--fixtures", "G54,G55", "--json"]));

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal((0.0, "G55"), (JsonText.Of(run).GetProperty("missingLength").GetDouble(), JsonText.Of(run).GetProperty("plate").GetProperty("fixture").GetString()));
        Assert.Equal(["G54", "G55"], Plates(plan).Select(plate => plate.GetProperty("fixture").GetString()));
        Assert.All(Plates(plan), plate => Assert.True(plate.GetProperty("seconds").GetDouble() > 1.0));
    }

    [Theory]
    [InlineData("G60 is not one of G54", "--fixtures", "G54,G60")]
    [InlineData("G54 is named twice", "--fixtures", "G54,g54")]
    [InlineData("cannot be used with --origin here", "--fixtures", "G54", "--origin", "here")]
    [InlineData("cannot be used with several tools (1, 3)", "--fixtures", "G54,G55", "--operations", "OPERATIONS")]
    [InlineData("--first-cell: there is no cell 3", "--fixtures", "G54,G55", "--first-cell", "3")]
    [InlineData("--fixtures cannot be used with --trajectory", "--fixtures", "G54", "--trajectory")]
    public async Task What_does_not_fit_is_refused(string message, params string[] options)
    {
        var operations = _folder.WithFile("two.json", """
            { "version": "1.0", "tools": [{"number": 1, "diameter": 1}, {"number": 3, "diameter": 1}], "operations": [
              { "id": "a", "kind": "engrave", "select": {"layers": ["TEXT"]}, "tool": 1 }, { "id": "b", "kind": "engrave", "select": "rest", "tool": 3 } ] }
            """);
        var run = await CliRun.RunAsync(["run", Drawing(), "--cut", "text", "--connect", "sim:", .. options.Select(word => word == "OPERATIONS" ? operations : word)]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    private static IReadOnlyList<JsonElement> Plates(CliRun run) => [.. JsonText.Of(run).GetProperty("plates").EnumerateArray()];

    /// <summary>15 by 6 mm, with the number of the copy.</summary>
    private string Drawing() => _folder.WithFile("fixtures.dxf", Encoding.UTF8.GetString(DxfText.WithEntities(
        (0, "LWPOLYLINE"), (8, "0"), (90, 4), (70, 1), (10, 0.0), (20, 0.0), (10, 15.0), (20, 0.0), (10, 15.0), (20, 6.0), (10, 0.0), (20, 6.0),
        (0, "TEXT"), (8, "TEXT"), (10, 2.0), (20, 2.0), (40, 2.0), (1, "[[copy]]")).ToAscii()));

    private async Task<string> AddressAsync(SimulatedController controller)
    {
        var (end, clock) = (await controller.ListenTcpAsync(0, _limit.Token), await controller.ListenClockAsync(_limit.Token));
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{end.Port}?clock={clock.Port}");
    }

    /// <summary>Sets work origins; the last one remains selected.</summary>
    private static async Task OriginsAsync(string address, params (string Name, string Place)[] origins)
    {
        foreach (var (name, place) in origins)
        {
            var set = await CliRun.RunAsync("origin", name, "--at", place, "--connect", address);
            Assert.True(set.ExitCode == ExitCode.Done, set.Error);
        }

        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("origin", origins[^1].Name, "--connect", address)).ExitCode);
    }

    /// <summary>The lower left corners of the outlines that were cut, in counts, in the order of cutting, each once.</summary>
    private static IEnumerable<(int X, int Y)> Cells(SimulatedController controller) =>
        controller.Record.Snapshot().Where(row => (row.Outputs & Tool) != 0).Select(row => ((int)Math.Floor(row.A / 20_000.0) * 20_000, (int)Math.Floor(row.B / 100_000.0) * 100_000)).Distinct();
}
