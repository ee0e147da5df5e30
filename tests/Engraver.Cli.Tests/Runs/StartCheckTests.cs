using System.Globalization;
using System.Text.Json;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The console runs the start checks of the desktop too, before any motion, with current data of the controller.</summary>
public class StartCheckTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(120);

    [Fact]
    public async Task A_run_says_line_by_line_what_was_looked_at_and_its_object_has_the_same_lines()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"));
        var json = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--journal", folder.PathOf("b.jsonl")));
        var quiet = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--quiet", "--journal", folder.PathOf("c.jsonl"));

        Assert.Equal(
            [
                "ok     The drawing has no errors.", "ok     The job has 6 segments.", "note   The drawing has no certificate; engraver certify verifies the program and writes one.", "ok     The link to sim: is up; the controller has just replied.", "ok     The controller is ready.", "ok     The motors are on.", "ok     No limit switch is active.",
                "ok     The abort input is not active.", "ok     No work origin is set; the drawing's zero is assumed at count 0 of the controller, machine position 0,0 mm.",
            ],
            run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Equal(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line[7..]), Sentences(json));
        Assert.All(json.GetProperty("checks").EnumerateArray(), check => Assert.Equal((true, false), (check.GetProperty("ok").GetBoolean(), check.GetProperty("warning").GetBoolean())));
        Assert.Equal("", quiet.Error);
    }

    [Fact]
    public async Task A_limit_that_is_hit_and_motors_that_are_off_are_on_the_list_and_only_the_first_prevents_the_start()
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        string[] words = [SampleDrawing.PathOf("paper-001"), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}")];
        controller.SetLimitSwitch(1, forward: true, active: true);

        var run = await CliRun.RunAsync(["run", .. words, "--journal", folder.PathOf("a.jsonl")]);
        var json = await CliRun.RunAsync(["run", .. words, "--json", "--journal", folder.PathOf("b.jsonl")]);
        var frame = await CliRun.RunAsync(["frame", .. words]);

        Assert.Equal((ExitCode.Refused, ExitCode.Refused, ExitCode.DrawingError), (run.ExitCode, json.ExitCode, frame.ExitCode));
        Assert.All([run.Error, frame.Error], said => Assert.Contains(said.Split('\n'), line => line.StartsWith("NOT OK ", StringComparison.Ordinal) && line.Contains("limit of axis Y", StringComparison.Ordinal) && line.Contains("move the machine off the switch", StringComparison.Ordinal)));
        Assert.Equal("refused", JsonText.Of(json).GetProperty("outcome").GetString());
        Assert.Contains(JsonText.Of(json).GetProperty("checks").EnumerateArray(), check => !check.GetProperty("ok").GetBoolean() && check.GetProperty("sentence").GetString()!.Contains("limit of axis Y", StringComparison.Ordinal));
        Assert.DoesNotContain(controller.Record.Snapshot(), row => row.A != 0 || row.B != 0);

        controller.SetLimitSwitch(1, forward: true, active: false);
        await using (var link = controller.OpenConnection()) await link.WriteAsync("MO\r"u8.ToArray(), patience.Token);
        var off = JsonText.Of(await CliRun.RunAsync(["run", .. words, "--json", "--journal", folder.PathOf("c.jsonl")]));
        Assert.Equal("complete", off.GetProperty("outcome").GetString());
        Assert.Contains(off.GetProperty("checks").EnumerateArray(), check => check.GetProperty("warning").GetBoolean() && check.GetProperty("sentence").GetString()!.StartsWith("The motors are off; the job switches them on", StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_frame_has_the_list_too_and_says_what_its_verb_does_about_it()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        string[] words = ["frame", SampleDrawing.PathOf("paper-001"), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}")];

        var told = await CliRun.RunAsync(words);
        var json = JsonText.Of(await CliRun.RunAsync([.. words, "--json"]));

        Assert.Contains("ok     The motors are on.", told.Error.Split('\n'));
        Assert.Contains("The motors are on.", Sentences(json));
        Assert.Equal("READY", json.GetProperty("state").GetString());
    }

    /// <summary>A cut 2.5 mm deep under a clearance of 4 mm; the frame and a dry run go 6.5 mm higher.</summary>
    [Theory]
    [InlineData("-2", "20", "JOB0033", true)]
    [InlineData("-5", "10", "JOB0034", false)]
    public async Task The_height_of_the_tool_is_held_against_its_travel_by_run_dry_run_and_frame(string least, string most, string id, bool isTooDeep)
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        var profile = folder.PathOf("mill.json");
        var mill = await File.ReadAllTextAsync(SampleDrawing.MillProfile, patience.Token);
        await File.WriteAllTextAsync(profile, mill.Replace("\"cutDepth\": 0", $"\"cutDepth\": 2.5, \"travelZ\": {{ \"min\": {least}, \"max\": {most} }}", StringComparison.Ordinal), patience.Token);
        string[] words = [SampleDrawing.PathOf("paper-001"), "--machine", profile, "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}")];

        var refused = isTooDeep
            ? await CliRun.RunAsync(["run", .. words, "--journal", folder.PathOf("a.jsonl")])
            : await CliRun.RunAsync(["run", .. words, "--dry-run", "--journal", folder.PathOf("a.jsonl")]);
        var frame = await CliRun.RunAsync(["frame", .. words]);

        Assert.Equal(ExitCode.DrawingError, refused.ExitCode);
        Assert.Contains(id, refused.Error, StringComparison.Ordinal);
        Assert.Contains("NOT OK ", refused.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("inside the travel", refused.Error, StringComparison.Ordinal);
        Assert.Equal(isTooDeep ? ExitCode.Done : ExitCode.DrawingError, frame.ExitCode);
        Assert.Equal(isTooDeep, frame.Error.Contains("ok     The frame around the placed job is inside the travel of the machine.", StringComparison.Ordinal));
        Assert.Equal(isTooDeep, controller.Record.Snapshot().Any(row => row.A != 0));
        var runs = await CliRun.RunAsync(isTooDeep ? ["run", .. words, "--dry-run", "--journal", folder.PathOf("b.jsonl")] : ["run", .. words, "--journal", folder.PathOf("b.jsonl")]);
        Assert.True(runs.ExitCode == ExitCode.Done, runs.Error);
        Assert.Contains("ok     The placed job is inside the travel of the machine.", runs.Error, StringComparison.Ordinal);
    }

    private static IEnumerable<string?> Sentences(JsonElement json) => json.GetProperty("checks").EnumerateArray().Select(check => check.GetProperty("sentence").GetString());
}
