using System.Text.Json.Nodes;
using Engraver.Cli.Tests.Verbs;
using Engraver.Simulator;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The stored state of a machine depends on the counts per millimetre of its profile, and is not used with another scale.</summary>
public sealed class OtherCountsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));

    /// <summary>Regression: profiles with equal homing, or without it, were confused without a warning, and the part was too large.</summary>
    [Fact]
    public async Task An_origin_is_refused_by_a_profile_with_other_counts_and_taken_when_it_is_set_anew()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, SerialNumber = 732_001 });
        var (right, wrong) = (_folder.WithFile("right.json", "{}"), _folder.WithFile("wrong.json", """{"countsPerMillimetreX": 800, "countsPerMillimetreY": 1000}"""));
        string[] at = ["--connect", await AddressAsync(controller)];
        await DoneAsync(["goto", "12,5", "--machine-position", "--machine", right, .. at]);
        await DoneAsync(["zero", "--machine", right, .. at]);
        var rows = controller.Record.Count;

        var run = await CliRun.RunAsync(["run", SampleDrawing.PathOf("paper-001"), "--machine", wrong, "--journal", _folder.PathOf("a.jsonl"), .. at]);
        var place = await CliRun.RunAsync(["goto", "3,0", "--machine", wrong, .. at]);
        var status = await CliRun.RunAsync(["status", "--machine", wrong, .. at]);

        Assert.Equal((ExitCode.Usage, ExitCode.DrawingError), (run.ExitCode, place.ExitCode));
        Assert.Contains("JOB0042", run.Error, StringComparison.Ordinal);
        Assert.All([run.Error, place.Error, status.Out], said => Assert.Contains("G54 was set with 1000 counts per millimetre in X; the current machine profile has 800", said, StringComparison.Ordinal));
        Assert.All([run.Error, place.Error, status.Out], said => Assert.Contains("engraver zero", said, StringComparison.Ordinal));
        Assert.Equal(rows, controller.Record.Count);
        await DoneAsync(["goto", "3,0", "--machine", right, .. at]);
        await DoneAsync(["zero", "--x", "--machine", wrong, .. at]);
        await DoneAsync(["goto", "0,0", "--machine", wrong, .. at]);
    }

    [Fact]
    public async Task A_homing_counts_only_for_the_counts_by_which_it_was_made()
    {
        await using var machine = new HomedSimulator(732_002);
        var (right, wrong) = (_folder.WithFile("right.json", HomedSimulator.Profile()), _folder.WithFile("wrong.json", HomedSimulator.Profile(500)));
        string[] at = ["--connect", await machine.AddressAsync(_limit.Token)];
        await DoneAsync(["home", "--machine", right, .. at]);
        await DoneAsync(["zero", "--machine", right, .. at]);

        var status = await CliRun.RunAsync(["status", "--machine", wrong, .. at]);
        var place = await CliRun.RunAsync(["goto", "30,40", "--machine-position", "--machine", wrong, .. at]);
        var zero = await CliRun.RunAsync(["zero", "--machine", wrong, .. at]);

        Assert.StartsWith("NOT HOMED", status.Out, StringComparison.Ordinal);
        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError), (place.ExitCode, zero.ExitCode));
        Assert.All([status.Out, place.Error, zero.Error], said => Assert.Contains("homed with 1000 counts per millimetre in X; the current machine profile has 500", said, StringComparison.Ordinal));
        Assert.StartsWith("READY", await DoneAsync(["status", "--machine", right, .. at]), StringComparison.Ordinal);
        await DoneAsync(["home", "--machine", wrong, .. at]);
        Assert.Contains("G54 was set with 1000", await DoneAsync(["status", "--machine", wrong, .. at]), StringComparison.Ordinal);
        await DoneAsync(["zero", "--machine", wrong, .. at]);
        Assert.StartsWith("READY", await DoneAsync(["status", "--machine", wrong, .. at]), StringComparison.Ordinal);
    }

    /// <summary>A file of an older version has no scale: it is accepted, and gets one with the next job.</summary>
    [Fact]
    public async Task A_file_without_counts_is_taken_and_gets_them_with_the_next_job()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, SerialNumber = 732_003 });
        var (first, other) = (_folder.WithFile("first.json", "{}"), _folder.WithFile("other.json", """{"countsPerMillimetreX": 800, "countsPerMillimetreY": 800}"""));
        string[] at = ["--connect", await AddressAsync(controller)];
        await DoneAsync(["zero", "--machine", first, .. at]);
        var file = Directory.GetFiles(MachineMemories.FolderIn(null), "*.json").Single(path => File.ReadAllText(path).Contains("732003", StringComparison.Ordinal));
        var kept = JsonNode.Parse(await File.ReadAllTextAsync(file, _limit.Token))!;
        Assert.Equal(1000, (int)kept["origins"]!["G54"]!["countsPerMillimetre"]!["x"]!);
        kept["origins"]!["G54"]!.AsObject().Remove("countsPerMillimetre");
        kept.AsObject().Remove("sum"); // In the format of an older version.
        await File.WriteAllTextAsync(file, kept.ToJsonString(), _limit.Token);

        Assert.StartsWith("READY", await DoneAsync(["status", "--machine", other, .. at]), StringComparison.Ordinal);
        await DoneAsync(["run", SampleDrawing.PathOf("paper-001"), "--machine", other, "--journal", _folder.PathOf("a.jsonl"), .. at]);

        Assert.Contains("was set with 800 counts", await DoneAsync(["status", "--machine", first, .. at]), StringComparison.Ordinal);
    }

    public void Dispose()
    {
        _folder.Dispose();
        _limit.Dispose();
    }

    private static async Task<string> DoneAsync(string[] words)
    {
        var done = await CliRun.RunAsync(words);
        Assert.True(done.ExitCode == ExitCode.Done, $"{string.Join(' ', words)}: {done.Error}");
        return done.Out;
    }

    private async Task<string> AddressAsync(SimulatedController controller)
    {
        var port = (await controller.ListenTcpAsync(0, _limit.Token)).Port;
        return $"tcp://127.0.0.1:{port}?clock={(await controller.ListenClockAsync(_limit.Token)).Port}";
    }
}
