using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The main job over a serial line: a pseudo-terminal with the byte times of its baud rate.</summary>
public class SerialRunTests
{
    private const byte Tool = 1;

    /// <summary>Four times real time, slow enough that a part is still being cut when the test interferes. The host uses the controller's clock, so that a busy
    /// computer does not trip the watchdog.</summary>
    private const double Slowly = 4.0;
    private const double AllowedDeviation = 0.0025 + 0.001;
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(180);

    /// <summary>The fast subset runs each mode once, the full run each drawing in both.</summary>
    public static TheoryData<string, string> MainJobs
    {
        get
        {
            var jobs = new TheoryData<string, string> { { "paper-001", "calls" }, { "gasket", "stream" } };
            if (!TestExtent.IsFull) return jobs;
            jobs.Add("paper-001", "stream");
            jobs.Add("gasket", "calls");
            jobs.Add("clock-dial", "stream");
            jobs.Add("clock-dial", "calls");
            return jobs;
        }
    }

    [Theory]
    [MemberData(nameof(MainJobs))]
    public async Task The_main_job_over_serial_leaves_nothing_out_and_loses_no_byte(string name, string mode)
    {
        using var folder = new TemporaryFolder();
        await using var controller = await ServeAsync(folder, double.PositiveInfinity);
        var run = await RunByItsClockAsync(folder, controller, SampleDrawing.PathOf(name), "--mode", mode);
        var report = JsonText.Of(run);

        Assert.Equal(("", ExitCode.Done), (run.Error, run.ExitCode));
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, AllowedDeviation);
        Assert.Equal((0, 0), (report.GetProperty("underruns").GetInt32(), report.GetProperty("rejected").GetInt32()));
        Assert.Equal(report.GetProperty("segmentsSent").GetInt32(), report.GetProperty("segmentsExecuted").GetInt32());
        Assert.Equal(0, controller.Status.Outputs & Tool);
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf(name), "--mode", mode, "--connect", "serial:///dev/ttyS0?baud=19200", "--json"));
        var (planned, took) = (report.GetProperty("plannedSeconds").GetDouble(), report.GetProperty("seconds").GetDouble());
        Assert.InRange(planned, 0.95 * took, 1.05 * took);
        Assert.Equal(planned, plan.GetProperty("seconds").GetProperty("total").GetDouble(), precision: 9);
    }

    [Theory]
    [InlineData(0.5, false)]
    [InlineData(0.05, true)]
    public async Task A_part_that_the_wire_does_not_carry_is_warned_of_and_neither_runs_the_buffer_dry(double segmentMillimetres, bool warned)
    {
        using var folder = new TemporaryFolder();
        await using var controller = await ServeAsync(folder, double.PositiveInfinity);
        var run = await RunByItsClockAsync(folder, controller, folder.WithFile("arc.dxf", Wave(800, segmentMillimetres)), "--fit-arcs", "off");
        var report = JsonText.Of(run);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(warned, run.Error.Contains("Warning MOT0020: At full feed, the path needs ", StringComparison.OrdinalIgnoreCase));
        Assert.Equal((800, 0), (report.GetProperty("segmentsExecuted").GetInt32(), report.GetProperty("underruns").GetInt32()));
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
    }

    /// <summary>The stroke runs from 10,10 to 10.5,10.017; the origin is at machine position 3,-2 mm.</summary>
    [Theory]
    [InlineData("stream", "origin", 3000, -2000)]
    [InlineData("stream", "stay", 13500, 8017)]
    [InlineData("calls", "stay", 13500, 8017)]
    [InlineData("program", "stay", 13500, 8017)]
    [InlineData("stream", "park", -1000, 4000)]
    [InlineData("calls", "park", -1000, 4000)]
    [InlineData("program", "park", -1000, 4000)]
    public async Task An_origin_is_where_it_cuts_and_a_finish_where_it_ends(string mode, string finish, int endX, int endY)
    {
        using var folder = new TemporaryFolder();
        await using var controller = await ServeAsync(folder, double.PositiveInfinity);
        var profile = folder.WithFile("machine.json", """{ "parkX": -1, "parkY": 4 }""");

        var run = await RunByItsClockAsync(folder, controller, folder.WithFile("wave.dxf", Wave(1, 0.5)), "--mode", mode, "--machine", profile, "--origin", "3,-2", "--finish", finish);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        var report = JsonText.Of(run);
        Assert.Equal("""{"x":3,"y":-2,"source":"given"}""", System.Text.Json.JsonSerializer.Serialize(report.GetProperty("origin")));
        Assert.Equal((endX, endY), (report.GetProperty("finalX").GetInt32(), report.GetProperty("finalY").GetInt32()));
        var rows = controller.Record.Snapshot();
        Assert.Equal((endX, endY, 0), ((int)rows[^1].A, (int)rows[^1].B, rows[^1].Outputs & Tool));
        var cut = rows.Where(sample => (sample.Outputs & Tool) != 0).ToList();
        Assert.Equal((13000, 13500), ((int)cut.Min(sample => sample.A), (int)cut.Max(sample => sample.A)));
        Assert.All(cut, sample => Assert.InRange((int)sample.B, 7999, 8018));
    }

    [Fact]
    public async Task Two_processes_talk_over_the_terminal_whose_name_goes_with_the_simulator()
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--serial", folder.PathOf("tty"), "--baud", "115200", "--speed", "4"); // At speed 1 there is no clock to share, and a busy computer may trip the watchdog.
        var clock = (await simulate.LineAsync("clock ", patience.Token)).Split(':')[^1];
        var network = await simulate.LineAsync("listening ", patience.Token);
        var serial = await simulate.LineAsync("listening ", patience.Token);
        using var host = EngraverProcess.Start(
            "run", folder.WithFile("short.dxf", Wave(20, 0.1)), "--connect", $"{serial["listening ".Length..]}?baud=115200&clock={clock}", "--json", "--journal", folder.PathOf("run.jsonl"));
        var report = System.Text.Json.JsonDocument.Parse(await host.Out.ReadToEndAsync(patience.Token)).RootElement;
        await host.WaitAsync(patience.Token);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        Assert.StartsWith("listening tcp://127.0.0.1:", network, StringComparison.Ordinal);
        Assert.Equal("listening serial://" + folder.PathOf("tty"), serial);
        Assert.Equal((ExitCode.Done, ExitCode.Done), (host.ExitCode, simulate.ExitCode));
        Assert.Equal("complete", report.GetProperty("outcome").GetString());
        Assert.False(Path.Exists(folder.PathOf("tty")) || new FileInfo(folder.PathOf("tty")).LinkTarget is not null);
    }

    [Theory]
    [InlineData("stream", "own")]
    [InlineData("calls", "own")]
    [InlineData("stream", "ports")]
    public async Task A_pulled_cable_is_exit_4_and_the_machine_stops_itself(string mode, string driver)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = await ServeAsync(folder, Slowly);
        var running = RunByItsClockAsync(folder, controller, driver, CancellationToken.None, SampleDrawing.PathOf("paper-001"), "--mode", mode);
        await CuttingAsync(controller, running, patience.Token);
        controller.DropConnections();
        var cutAt = controller.Status.Sample;
        var run = await running;
        await controller.WaitUntilAsync(status => !status.IsMoving && (status.Outputs & Tool) == 0, patience.Token);

        Assert.Equal(ExitCode.LinkLost, run.ExitCode);
        Assert.Equal("linkLost", JsonText.Of(run).GetProperty("outcome").GetString());
        Assert.InRange(controller.Record[controller.Record.Count - 1].Sample - cutAt, 0, 1500);
    }

    [Theory]
    [InlineData("stream", "own")]
    [InlineData("calls", "own")]
    [InlineData("stream", "ports")]
    public async Task A_stop_at_19200_baud_is_exit_5_with_the_machine_at_rest_and_the_tool_off(string mode, string driver)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        using var stop = new CancellationTokenSource();
        await using var controller = await ServeAsync(folder, Slowly);
        var running = RunByItsClockAsync(folder, controller, driver, stop.Token, SampleDrawing.PathOf("paper-001"), "--mode", mode);
        await CuttingAsync(controller, running, patience.Token);
        await stop.CancelAsync();
        var run = await running;

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (run.ExitCode, JsonText.Of(run).GetProperty("outcome").GetString()));
        Assert.True(controller.Status.IsIdle);
        Assert.Equal(0, controller.Status.Outputs & Tool);
    }

    [Theory]
    [InlineData(ExitCode.LinkLost, "run", "DRAWING", "--connect", "serial:///dev/no-such-device")]
    [InlineData(ExitCode.LinkLost, "run", "DRAWING", "--connect", "serial:///dev/null?flow=none")]
    [InlineData(ExitCode.LinkLost, "run", "DRAWING", "--connect", "serial:///dev/no-such-device?driver=ports")]
    [InlineData(ExitCode.Usage, "run", "DRAWING", "--connect", "serial:///dev/ttyS0?driver=usb")]
    [InlineData(ExitCode.Usage, "run", "DRAWING", "--connect", "serial:///dev/ttyS0?baud=7")]
    [InlineData(ExitCode.Usage, "simulate", "--serial", "/no/such/folder/tty")]
    [InlineData(ExitCode.Usage, "simulate", "--serial", "DRAWING")]
    [InlineData(ExitCode.Usage, "simulate", "--baud", "7")]
    [InlineData(ExitCode.Usage, "simulate", "--tcp", "0", "--baud", "9600")]
    public async Task What_cannot_be_a_serial_line_is_one_sentence_and_its_exit_code(int code, params string[] args)
    {
        var run = await CliRun.RunAsync([.. args.Select(arg => arg == "DRAWING" ? SampleDrawing.PathOf("paper-001") : arg)]);

        Assert.Equal(code, run.ExitCode);
        Assert.Single(run.Error.TrimEnd().Split('\n'));
    }

    /// <summary>Waits until the tool cuts; reports a run that ended before.</summary>
    private static async Task CuttingAsync(SimulatedController controller, Task<CliRun> running, CancellationToken cancellation)
    {
        var cutting = controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, cancellation);
        Assert.True(await Task.WhenAny(running, cutting) == cutting, running.IsCompleted ? (await running).Error + (await running).Out : "");
        await cutting;
    }

    private static async Task<SimulatedController> ServeAsync(TemporaryFolder folder, double speed)
    {
        // At maximum speed only the bytes on the wire advance the clock, so that a busy computer has no effect.
        TimeProvider time = double.IsPositiveInfinity(speed) ? new ManualTimeProvider() : TimeProvider.System;
        var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = time });
        await controller.ServeSerialAsync(folder.PathOf("tty"), 19200, CancellationToken.None);
        return controller;
    }

    private static Task<CliRun> RunByItsClockAsync(TemporaryFolder folder, SimulatedController controller, params string[] args) => RunByItsClockAsync(folder, controller, "own", CancellationToken.None, args);

    private static async Task<CliRun> RunByItsClockAsync(TemporaryFolder folder, SimulatedController controller, string driver, CancellationToken stop, params string[] args)
    {
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        var address = string.Create(CultureInfo.InvariantCulture, $"serial://{folder.PathOf("tty")}?baud=19200&driver={driver}&clock={clock.Port}");
        return await CliRun.RunAsync(stop, ["run", .. args, "--connect", address, "--json", "--journal", folder.PathOf("run.jsonl")]);
    }

    /// <summary>An open polyline of many short segments without a sharp corner.</summary>
    private static string Wave(int segments, double step)
    {
        var text = new StringBuilder("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n");
        text.Append(CultureInfo.InvariantCulture, $"{segments + 1}\n70\n0\n");
        for (var i = 0; i <= segments; i++) text.Append(CultureInfo.InvariantCulture, $"10\n{10 + (i * step)}\n20\n{10 + (step * Math.Sin(i / 30.0))}\n");
        return text.Append("0\nENDSEC\n0\nEOF\n").ToString();
    }
}
