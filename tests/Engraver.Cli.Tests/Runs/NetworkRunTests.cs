using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The main job over sockets, and all failures of the link.</summary>
public class NetworkRunTests
{
    private const byte Tool = 1;

    /// <summary>Paper 001, figure 5: written by hand, so that the comparison of record and drawing uses no reader of this program.</summary>
    private static readonly Segment[] s_paperPart =
    [
        Segment.FromLine(new Point2D(50, 50), new Point2D(150, 50)),
        Segment.FromLine(new Point2D(150, 50), new Point2D(150, 150)),
        Segment.FromArc(new ArcSegment(new Point2D(100, 150), 50, Angle.Zero, Angle.FromDegrees(180))),
        Segment.FromLine(new Point2D(50, 150), new Point2D(50, 50)),
    ];

    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(180);

    /// <summary>The fast subset runs the main mode between two processes; the others between a process and a controller of the test, below, and all of them
    /// over each link in <c>EveryStrategyTests</c>.</summary>
    public static TheoryData<string> Modes => TestExtent.IsFull ? ["stream", "calls", "program"] : ["stream"];

    public static TheoryData<string> LentModes => TestExtent.IsFull ? ["stream", "program"] : ["program"];

    public static TheoryData<double, string> Speeds => TestExtent.IsFull ? new() { { 5.0, "stream" }, { 20.0, "stream" }, { 20.0, "program" }, { 200.0, "calls" } } : new() { { 20.0, "program" }, { 200.0, "calls" } };

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Two_processes_run_the_job_over_TCP_and_the_record_shows_it(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--speed", "max", "--record", folder.PathOf("record.csv"));
        var clock = (await simulate.LineAsync("clock 127.0.0.1:", patience.Token))["clock 127.0.0.1:".Length..];
        var address = (await simulate.LineAsync("listening ", patience.Token))["listening ".Length..] + "?clock=" + clock;
        using var host = EngraverProcess.Start("run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--mode", mode, "--corner-tolerance", "0", "--json", "--journal", folder.PathOf("run.jsonl"));
        var report = System.Text.Json.JsonDocument.Parse(await host.Out.ReadToEndAsync(patience.Token)).RootElement;
        await host.WaitAsync(patience.Token);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.Done, ExitCode.Done), (host.ExitCode, simulate.ExitCode));
        Assert.Equal("polled", report.GetProperty("deviationSource").GetString());
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, 0.0035);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        AssertRecord(await File.ReadAllLinesAsync(folder.PathOf("record.csv")));
    }

    /// <summary>Regression: a line ten times too long was cut, and the run was reported as complete with a deviation of 396 mm.</summary>
    [Fact]
    public async Task A_line_that_arrives_ten_times_as_long_ends_as_deviated_with_exit_1()
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        await using var proxy = new CorruptingProxy(place.Port, line => line == "LI 100000,0" ? "LI 1000000,0" : line);
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", proxy.Address + await ClockAsync(controller), "--corner-tolerance", "0", "--json", "--journal", folder.PathOf("run.jsonl"));

        Assert.Equal((ExitCode.DrawingError, "deviated"), (run.ExitCode, JsonText.Of(run).GetProperty("outcome").GetString()));
        Assert.Matches("The machine was at 15[0-9]{4},50000 of the drawing .counts., [0-9]+ counts off the planned path", run.Error);
        Assert.Contains("\"outcome\":\"deviated\"", (await File.ReadAllLinesAsync(folder.PathOf("run.jsonl")))[^1], StringComparison.Ordinal);
        Assert.Equal(0, controller.Status.Outputs);
        Assert.InRange(controller.Record.Snapshot().Max(row => row.A), 150_000, 160_000); // Stopped, not completed.
    }

    [Fact]
    public async Task Simulate_has_the_serial_number_that_it_is_given()
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--serial-number", "4711");
        var address = await simulate.LineAsync("listening ", patience.Token);
        var found = await CliRun.RunAsync("discover", address["listening ".Length..]);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        Assert.Contains("4711", found.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("column")]
    [InlineData("blank")]
    public async Task Simulate_prints_numbers_with_and_without_a_blank_between_them(string numbers)
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--speed", "max", "--numbers", numbers);
        var address = (await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token))["listening tcp://127.0.0.1:".Length..];
        using var client = new System.Net.Sockets.TcpClient();
        await client.ConnectAsync("127.0.0.1", int.Parse(address, CultureInfo.InvariantCulture), patience.Token);
        await client.GetStream().WriteAsync("MG 2,-8\r"u8.ToArray(), patience.Token);
        var answer = new byte[64];
        var count = await client.GetStream().ReadAtLeastAsync(answer, 16, cancellationToken: patience.Token);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        Assert.StartsWith(numbers == "column" ? " 2.0000-8.0000\r\n" : " 2.0000 -8.0000\r\n", System.Text.Encoding.ASCII.GetString(answer, 0, count), StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Speeds))]
    public async Task A_controller_that_is_faster_than_the_wall_runs_the_job_to_its_end(double speed, string mode)
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed });
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller) + await ClockAsync(controller), "--mode", mode, "--corner-tolerance", "0", "--json", "--journal", folder.PathOf("run.jsonl"));

        Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        Assert.Equal(0.0, JsonText.Of(run).GetProperty("missingLength").GetDouble());
        AssertPart([.. controller.Record.Snapshot().Select(row => new TraceSample(row.Sample / 1000.0, row.A / 1000.0, row.B / 1000.0, (row.Outputs & Tool) != 0))]);
    }

    [Theory]
    [MemberData(nameof(LentModes))]
    public async Task After_a_killed_process_the_next_run_gives_the_owners_program_and_settings_back(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        Assert.Equal(":::::::", await AskAsync(controller, "DL\r#OWNER\rMG 1\rEN\r\\VSS=6002;VAS=51200;SPA=1234;VR 0.3;CW 2\r", patience.Token));
        const string Questions = "MG _VSS,_VAS,_SPA,_VRS{$8.4},_CW\rUL\r";
        var before = await AskAsync(controller, Questions, patience.Token);
        string[] words = ["run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller) + await ClockAsync(controller), "--mode", mode, "--journal", folder.PathOf("run.jsonl")];
        using (var host = EngraverProcess.Start(words))
        {
            await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, patience.Token);
            host.Kill();
            await controller.WaitUntilAsync(status => !status.IsMoving && status.Outputs == 0, patience.Token);
        }

        Assert.NotEqual(before, await AskAsync(controller, Questions, patience.Token));
        var run = await CliRun.RunAsync(words);

        Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        Assert.Equal(before, await AskAsync(controller, Questions, patience.Token));
    }

    [Fact]
    public async Task A_closed_port_is_exit_4_with_one_sentence()
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", $"tcp://127.0.0.1:{await UnusedPortAsync()}");

        Assert.Equal(ExitCode.LinkLost, run.ExitCode);
        Assert.Single(run.Error.TrimEnd().Split('\n'));
        Assert.DoesNotContain("   at ", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Bytes of the session up to the start list, and some of the job's preparation.</summary>
    private const long BehindTheList = 2_000;

    [Fact]
    public async Task A_refused_command_is_exit_3_and_says_which_and_why()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        controller.Schedule(new ScheduledFault { Kind = FaultKind.LimitSwitch, Axis = "A", Forward = true, AtByte = BehindTheList }); // An earlier fault would make a start check fail.
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller) + await ClockAsync(controller), "--json", "--journal", folder.PathOf("run.jsonl"));

        Assert.Equal(ExitCode.Refused, run.ExitCode);
        Assert.Equal("refused", JsonText.Of(run).GetProperty("outcome").GetString());
        Assert.Contains("22", run.Error, StringComparison.Ordinal);
        Assert.Contains("limit switch", run.Error, StringComparison.OrdinalIgnoreCase);
        Assert.Equal(0, controller.Status.Outputs & Tool);
    }

    [Fact]
    public async Task A_controller_in_which_somebody_elses_thread_runs_is_refused_and_its_thread_goes_on()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using (var other = controller.OpenConnection())
        {
            await other.WriteAsync("DL\r#LOOP\rWT 100\rJP#LOOP\rEN\r\\XQ#LOOP,3\r"u8.ToArray());
            await controller.WaitUntilAsync(status => status.RunningThreads == 8, new CancellationTokenSource(s_patience).Token);
        }

        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller) + await ClockAsync(controller), "--journal", folder.PathOf("run.jsonl"));

        Assert.Equal(ExitCode.Refused, run.ExitCode);
        Assert.Contains("Thread 3", run.Error, StringComparison.Ordinal);
        Assert.Equal(8, controller.Status.RunningThreads);
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task A_link_cut_in_the_middle_is_exit_4_with_the_last_known_position_and_the_machine_stops_itself(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions());
        var running = CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller), "--mode", mode, "--json", "--journal", folder.PathOf("run.jsonl"));
        var cutting = controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, patience.Token);
        Assert.True(await Task.WhenAny(running, cutting) == cutting, running.IsCompleted ? (await running).Error + (await running).Out : "");
        await cutting;
        controller.DropConnections();
        var cutAt = controller.Status.Sample;
        var run = await running;
        await controller.WaitUntilAsync(status => !status.IsMoving && (status.Outputs & Tool) == 0, patience.Token);

        Assert.Equal(ExitCode.LinkLost, run.ExitCode);
        Assert.Equal("linkLost", JsonText.Of(run).GetProperty("outcome").GetString());
        Assert.True(JsonText.Of(run).GetProperty("finalX").GetInt32() >= 50000);
        AssertSafeWithin(controller.Record, cutAt, samples: 1500);
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task A_killed_host_leaves_the_output_off_and_the_machine_at_rest_within_a_second_and_a_half(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions());
        using var host = EngraverProcess.Start("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller), "--mode", mode, "--journal", folder.PathOf("run.jsonl"));
        await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, patience.Token);
        host.Kill();
        var killedAt = controller.Status.Sample;
        await controller.WaitUntilAsync(status => !status.IsMoving && (status.Outputs & Tool) == 0, patience.Token);

        AssertSafeWithin(controller.Record, killedAt, samples: 1500);
    }

    [Theory]
    [InlineData("stream", PosixSignal.SIGINT)]
    [InlineData("calls", PosixSignal.SIGTERM)]
    [InlineData("program", PosixSignal.SIGINT)]
    public async Task A_signal_stops_the_machine_first_and_then_the_program_with_exit_5(string mode, PosixSignal signal)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions());
        using var host = EngraverProcess.Start("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller), "--mode", mode, "--json", "--journal", folder.PathOf("run.jsonl"));
        await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, patience.Token);
        host.Signal(signal);
        var report = System.Text.Json.JsonDocument.Parse(await host.Out.ReadToEndAsync(patience.Token)).RootElement;
        await host.WaitAsync(patience.Token);

        Assert.Equal(ExitCode.StoppedByOperator, host.ExitCode);
        Assert.Equal("stopped", report.GetProperty("outcome").GetString());
        Assert.True(controller.Status.IsIdle);
        Assert.Equal(0, controller.Status.Outputs & Tool);
        var last = controller.Record[controller.Record.Count - 1];
        Assert.Equal((last.A, last.B), (report.GetProperty("finalX").GetInt32(), report.GetProperty("finalY").GetInt32()));
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    public async Task A_tool_that_somebody_left_on_is_off_before_the_first_rapid(string mode)
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using (var other = controller.OpenConnection()) await other.WriteAsync("SB1\r"u8.ToArray());
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", await AddressAsync(controller) + await ClockAsync(controller), "--mode", mode, "--journal", folder.PathOf("run.jsonl"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.DoesNotContain(controller.Record.Snapshot(), row => (row.Outputs & Tool) != 0 && row.A is > 100 and < 49900);
    }

    [Fact]
    public async Task A_link_that_never_came_up_is_one_JSON_object_all_the_same()
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", $"tcp://127.0.0.1:{await UnusedPortAsync()}", "--json");

        Assert.Equal((ExitCode.LinkLost, "linkLost"), (run.ExitCode, JsonText.Of(run).GetProperty("outcome").GetString()));
    }

    private static async Task<string> AddressAsync(SimulatedController controller)
    {
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}");
    }

    /// <summary>A controller with a speed other than 1 is run with its own clock.</summary>
    private static async Task<string> ClockAsync(SimulatedController controller)
    {
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        return string.Create(CultureInfo.InvariantCulture, $"?clock={clock.Port}");
    }

    /// <summary>All replies until every command is answered: each reply ends with a prompt.</summary>
    private static async Task<string> AskAsync(SimulatedController controller, string commands, CancellationToken cancellation)
    {
        await using var other = controller.OpenConnection();
        await other.WriteAsync(System.Text.Encoding.ASCII.GetBytes(commands), cancellation);
        var reply = new byte[65536];
        return System.Text.Encoding.ASCII.GetString(reply, 0, await other.ReadAsync(reply, cancellation));
    }

    private static async Task<int> UnusedPortAsync()
    {
        await using var controller = new SimulatedController(new SimulatorOptions());
        return (await controller.ListenTcpAsync(0, CancellationToken.None)).Port;
    }

    /// <summary>After the moment, the last row of the record with motion or tool on is within the time limit, and the tool is off at the end.</summary>
    private static void AssertSafeWithin(MotionRecord record, long moment, int samples)
    {
        var rows = record.Snapshot();
        var last = rows[^1];

        Assert.Equal(0, last.Outputs & Tool);
        Assert.InRange(last.Sample - moment, 0, samples);
        Assert.Contains(rows, row => (row.Outputs & Tool) != 0);
    }

    /// <summary>The record contains the complete part of the paper and ends at rest with the tool off.</summary>
    private static void AssertRecord(string[] lines)
    {
        Assert.Equal("t,a,b,c,d,outputs", lines[0]);
        Assert.EndsWith(",0,0,0,0,0", lines[^1], StringComparison.Ordinal); // Back at the drawing's start.
        AssertPart([.. lines.Skip(1).Select(Sample)]);
    }

    private static void AssertPart(IReadOnlyList<TraceSample> trace)
    {
        var found = TraceComparison.Compare(s_paperPart, trace, UsualOptions.Trace);
        Assert.InRange(found.MaxDeviation, 0.0, 0.0035);
        Assert.Equal(0.0, found.MissingLength);
    }

    private static TraceSample Sample(string line)
    {
        var cells = line.Split(',');
        double Number(int cell) => double.Parse(cells[cell], CultureInfo.InvariantCulture);
        return new TraceSample(Number(0), Number(1) / 1000.0, Number(2) / 1000.0, (int.Parse(cells[5], CultureInfo.InvariantCulture) & Tool) != 0);
    }
}
