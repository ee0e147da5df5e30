using System.Globalization;
using System.Text.Json;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>status, zero and goto against a simulated controller in another process, which keeps its place from verb to verb as a machine does.</summary>
public class HandVerbTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(120);

    [Fact]
    public async Task The_machine_is_moved_zeroed_and_moved_through_the_origin_and_a_killed_run_changes_nothing()
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        var address = string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");

        Assert.Equal((0.0, 0.0, null), Places(await SeenAsync("status", "--connect", address, "--json")));
        Assert.Equal((12.0, -7.5, null), Places(await SeenAsync("goto", "12,-7.5", "--machine-position", "--connect", address, "--json")));
        var nowhere = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--json", "--journal", folder.PathOf("a.jsonl"));
        Assert.Equal((ExitCode.Usage, "refused"), (nowhere.ExitCode, JsonText.Of(nowhere).GetProperty("outcome").GetString()));
        Assert.Contains("JOB0008", nowhere.Error, StringComparison.Ordinal);
        Assert.Contains("engraver zero", nowhere.Error, StringComparison.Ordinal);

        Assert.Equal((11.5, -7.5, null), Places(await SeenAsync("jog", "--x", "-0.5", "--connect", address, "--json")));
        Assert.Equal((12.0, -7.5, null), Places(await SeenAsync("jog", "--x", "0.5", "--feed", "300", "--connect", address, "--json")));
        Assert.Equal((12.0, -7.5, 0.0), Places(await SeenAsync("zero", "--connect", address, "--json")));
        Assert.Equal((15.0, -7.5, 3.0), Places(await SeenAsync("goto", "3,0", "--connect", address, "--json")));
        using (var host = EngraverProcess.Start("run", SampleDrawing.PathOf("gasket"), "--connect", address, "--journal", folder.PathOf("killed.jsonl")))
        {
            await controller.WaitUntilAsync(status => status.IsMoving && status.Outputs != 0, patience.Token);
            host.Kill();
            await host.WaitAsync(patience.Token);
        }

        await controller.WaitUntilAsync(status => !status.IsMoving && status.Outputs == 0, patience.Token); // the watchdog
        var run = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--json", "--journal", folder.PathOf("b.jsonl")));
        Assert.Equal(("complete", 12000, -7500), (run.GetProperty("outcome").GetString(), run.GetProperty("finalX").GetInt32(), run.GetProperty("finalY").GetInt32()));
    }

    [Theory]
    [InlineData("jog")]
    [InlineData("jog", "--x", "0")]
    [InlineData("jog", "--x", "1", "--feed", "-5")]
    [InlineData("goto", "1;2")]
    [InlineData("zero", "--origin", "G60")]
    public async Task What_is_no_move_is_a_usage_error_before_anybody_is_asked(params string[] words)
    {
        var run = await CliRun.RunAsync([.. words, "--connect", "tcp://127.0.0.1:1"]);

        Assert.Equal((ExitCode.Usage, ""), (run.ExitCode, run.Out));
        Assert.NotEqual("", run.Error);
    }

    private static async Task<JsonElement> SeenAsync(params string[] words)
    {
        var run = await CliRun.RunAsync(words);
        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        return JsonText.Of(run);
    }

    private static (double X, double Y, double? Work) Places(JsonElement seen) =>
        (seen.GetProperty("machine").GetProperty("x").GetDouble(), seen.GetProperty("machine").GetProperty("y").GetDouble(), seen.GetProperty("work").GetProperty("x") is { ValueKind: JsonValueKind.Number } x ? x.GetDouble() : null);
}
