using System.Globalization;
using System.Text.Json;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>status, zero and goto against a simulated controller in another process, which keeps its position between verbs like a machine.</summary>
public class MachineVerbTests
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

    /// <summary>A job of another program moves the machine over another connection: no origin can be set.</summary>
    [Fact]
    public async Task An_origin_is_not_set_while_the_machine_moves()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        var address = string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
        await CliRun.RunAsync("zero", "--connect", address);
        using var other = new System.Net.Sockets.TcpClient("127.0.0.1", port);
        await other.GetStream().WriteAsync("SPA=100;PRA=2000000;BGA\r"u8.ToArray(), patience.Token);
        await controller.WaitUntilAsync(status => status.IsMoving, patience.Token);

        foreach (var words in (string[][])[["zero", "--connect", address], ["origin", "G54", "--at", "1,2", "--connect", address]])
        {
            var run = await CliRun.RunAsync(words);

            Assert.Equal((words[0], ExitCode.DrawingError), (words[0], run.ExitCode));
            Assert.Contains("the machine is moving", run.Error, StringComparison.Ordinal);
        }

        await other.GetStream().WriteAsync("STA\r"u8.ToArray(), patience.Token);
        await controller.WaitUntilAsync(status => !status.IsMoving, patience.Token);
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("zero", "--connect", address)).ExitCode);
    }

    [Fact]
    public async Task A_tool_that_an_axis_holds_is_stepped_up_and_down_and_one_without_is_told()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        string[] mill = ["--machine", SampleDrawing.MillProfile, "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}"), "--json"];

        Assert.Equal(7.5, Height(await SeenAsync(["jog", "--z", "7.5", .. mill])));
        var down = await SeenAsync(["jog", "--z", "-2.25", "--x", "3", .. mill]);
        Assert.Equal((5.25, 3.0), (Height(down), Places(down).X));
        var far = await CliRun.RunAsync(["jog", "--z", "1e9", .. mill]);
        var flat = await CliRun.RunAsync(["jog", "--z", "1", .. mill.AsSpan(2).ToArray()]);
        var held = await CliRun.RunAsync(["jog", "--hold", "Z-", .. mill.AsSpan(2).ToArray()]);

        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError, ExitCode.DrawingError), (far.ExitCode, flat.ExitCode, held.ExitCode));
        Assert.Contains("32-bit range", far.Error, StringComparison.Ordinal);
        Assert.All([flat.Error, held.Error], said => Assert.Contains("no Z axis", said, StringComparison.Ordinal));
        Assert.Equal((3000, 4200), (controller.Record.Snapshot()[^1].A, controller.Record.Snapshot()[^1].C));
    }

    [Fact]
    public async Task The_zero_is_set_by_touched_edges_by_the_middle_of_two_touches_and_by_a_place_of_the_drawing_and_an_origin_is_chosen()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        string[] machine = ["--json", "--connect", await AddressAsync(controller, patience.Token)];
        Task<JsonElement> DoAsync(params string[] words) => SeenAsync([.. words, .. machine]);

        await DoAsync("goto", "10,20", "--machine-position");
        Assert.Equal((null, null), Work(await DoAsync("zero", "--edge", "left", "--radius", "1.5"))); // Half an origin is not an origin.
        await DoAsync("goto", "30,7", "--machine-position");
        Assert.Equal((18.5, -1.5), Work(await DoAsync("zero", "--edge", "bottom", "--radius", "1.5")));
        Assert.Equal((18.5, 1.5), Work(await DoAsync("zero", "--edge", "top", "--radius", "1.5")));
        await DoAsync("goto", "50,9", "--machine-position");
        Assert.Equal((10.0, 3.5), Work(await DoAsync("zero", "--centre", "30,7", "--x")));
        Assert.Equal((10.0, 1.0), Work(await DoAsync("zero", "--centre", "30,7")));
        var point = await DoAsync("zero", "--point", "5,-2.5", "--origin", "G55");
        Assert.Equal(("G55", (5.0, -2.5)), (Name(point), Work(point)));
        var chosen = await DoAsync("origin", "g54");
        Assert.Equal(("G54", (10.0, 1.0)), (Name(chosen), Work(chosen)));
        Assert.Equal("G54", Name(await DoAsync("origin")));
        var typed = await DoAsync("origin", "G57", "--at", "40,11.5");
        Assert.Equal(("G57", (10.0, -2.5)), (Name(typed), Work(typed)));
        Assert.Equal((8.0, -2.5), Work(await DoAsync("origin", "--at", "42,11.5")));
        Assert.Contains("no Z axis", (await CliRun.RunAsync(["origin", "--at", "1,2,3", .. machine])).Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Motors_are_switched_and_places_that_have_a_name_are_gone_to()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        string[] machine = ["--json", "--connect", await AddressAsync(controller, patience.Token)];
        string[] mill = ["--machine", SampleDrawing.MillProfile, .. machine];

        Assert.Equal(["A", "B"], Off(await SeenAsync(["motors", "off", .. machine])));
        Assert.Equal(ExitCode.Refused, (await CliRun.RunAsync(["jog", "--x", "1", .. machine])).ExitCode);
        Assert.Empty(Off(await SeenAsync(["motors", "ON", .. machine])));
        var park = await CliRun.RunAsync(["goto", "park", .. machine]);
        var flat = await CliRun.RunAsync(["goto", "clearance", .. machine]);
        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError), (park.ExitCode, flat.ExitCode));
        Assert.Contains("parkX", park.Error, StringComparison.Ordinal);
        Assert.Contains("clearance height", flat.Error, StringComparison.Ordinal);
        await SeenAsync(["jog", "--z", "-3", .. mill]);
        Assert.Equal((5.0, 6.0), Work(await SeenAsync(["zero", "--point", "5,6", "--z", .. mill]))); // all three
        Assert.Equal(-3.5, WorkZero(await SeenAsync(["zero", "--height", "0.5", .. mill])));
        Assert.Equal((5.0, 6.0), Work(await SeenAsync(["status", .. mill]))); // the height alone
        Assert.Contains("no Z axis", (await CliRun.RunAsync(["zero", "--height", "0.5", .. machine])).Error, StringComparison.Ordinal);
        await SeenAsync(["zero", .. mill]);
        Assert.Equal(1.0, Height(await SeenAsync(["goto", "clearance", .. mill]))); // 4 mm over the zero at -3
    }

    [Theory]
    [InlineData("zero", "--edge", "left", "--centre", "1,2")]
    [InlineData("zero", "--edge", "left", "--y")]
    [InlineData("zero", "--edge", "middle")]
    [InlineData("zero", "--radius", "2")]
    [InlineData("zero", "--edge", "left", "--radius", "-2")]
    [InlineData("zero", "--point", "1")]
    [InlineData("zero", "--centre", "1,2", "--z")]
    [InlineData("zero", "--edge", "left", "--height", "1")]
    [InlineData("zero", "--height", "high")]
    [InlineData("zero", "--height", "NaN")]
    [InlineData("origin", "G60")]
    [InlineData("origin", "--at", "1")]
    [InlineData("origin", "--at", "1,2,3,4")]
    [InlineData("origin", "--at", "1,NaN")]
    [InlineData("motors")]
    [InlineData("motors", "perhaps")]
    [InlineData("goto", "home")]
    [InlineData("jog")]
    [InlineData("jog", "--z", "0")]
    [InlineData("jog", "--z", "1", "--hold", "Z+")]
    [InlineData("jog", "--hold", "W+")]
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

    private static async Task<string> AddressAsync(SimulatedController controller, CancellationToken patience)
    {
        var clock = (await controller.ListenClockAsync(patience)).Port;
        var port = (await controller.ListenTcpAsync(0, patience)).Port;
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
    }

    private static (double? X, double? Y) Work(JsonElement seen) => (Number(seen.GetProperty("work").GetProperty("x")), Number(seen.GetProperty("work").GetProperty("y")));

    private static double? Number(JsonElement value) => value.ValueKind == JsonValueKind.Number ? Math.Round(value.GetDouble(), 6) : null;

    private static string? Name(JsonElement seen) => seen.GetProperty("work").GetProperty("name").GetString();

    private static IEnumerable<string?> Off(JsonElement seen) => seen.GetProperty("motorsOff").EnumerateArray().Select(axis => axis.GetString());

    /// <summary>Machine height of the work's zero.</summary>
    private static double WorkZero(JsonElement seen) => Height(seen) - seen.GetProperty("work").GetProperty("z").GetDouble();

    private static double Height(JsonElement seen) => seen.GetProperty("machine").GetProperty("z").GetDouble();

    private static (double X, double Y, double? Work) Places(JsonElement seen) =>
        (seen.GetProperty("machine").GetProperty("x").GetDouble(), seen.GetProperty("machine").GetProperty("y").GetDouble(), seen.GetProperty("work").GetProperty("x") is { ValueKind: JsonValueKind.Number } x ? x.GetDouble() : null);
}
