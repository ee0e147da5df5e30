using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Signals while a verb would not end on its own.</summary>
public class SignalTests
{
    private const byte Tool = 1;
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(2);

    /// <summary>A line of two kilometres, whose verification allows days of machine time.</summary>
    private const string LongDrawing = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0.0\n20\n0.0\n11\n2000000.0\n21\n0.0\n0\nENDSEC\n0\nEOF\n";

    [Theory]
    [InlineData(PosixSignal.SIGINT, "info")]
    [InlineData(PosixSignal.SIGTERM, "sequence")]
    [InlineData(PosixSignal.SIGTERM, "plan")]
    public async Task A_signal_ends_a_verb_that_hears_nothing(PosixSignal signal, string verb)
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        var drawing = NamedPipe.Make(folder.PathOf("drawing.dxf"));
        var opening = NamedPipe.WriterAsync(drawing);
        using var program = EngraverProcess.Start(verb, drawing, "--json");
        await using var silentWriter = await opening.WaitAsync(patience.Token); // From here on the program waits for the rest of the drawing.
        program.Signal(signal);
        var (said, why) = (await program.Out.ReadToEndAsync(patience.Token), await program.Error.ReadToEndAsync(patience.Token));
        await program.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "", "engraver: Stopped by the operator."), (program.ExitCode, said, why.Trim()));
    }

    /// <summary>The axes of the program move endlessly: its replay does not end before the timeout of the test.</summary>
    [Fact]
    public async Task Ctrl_C_ends_a_verification_that_replays()
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        var drawing = folder.WithFile("drawing.dxf", LongDrawing);
        var posted = NamedPipe.Make(folder.PathOf("job.dmc"));
        var opening = NamedPipe.WriterAsync(posted);
        using var program = EngraverProcess.Start("verify", posted, "--against", drawing, "--json");
        await using (var writer = await opening.WaitAsync(patience.Token)) // The drawing has been read.
        {
            await writer.WriteAsync("#JOB\n#LOOP\nPRA=2;BGA;AMA\nPRA=-2;BGA;AMA\nJP#LOOP\n"u8.ToArray(), patience.Token);
        }

        program.Signal(PosixSignal.SIGINT);
        var (said, why) = (await program.Out.ReadToEndAsync(patience.Token), await program.Error.ReadToEndAsync(patience.Token));
        await program.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "", "engraver: Stopped by the operator."), (program.ExitCode, said, why.Trim()));
    }

    [Fact]
    public async Task A_run_that_is_stopped_before_it_is_prepared_prints_its_one_object()
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        var drawing = NamedPipe.Make(folder.PathOf("drawing.dxf"));
        var opening = NamedPipe.WriterAsync(drawing);
        using var program = EngraverProcess.Start("run", drawing, "--connect", "sim:", "--json", "--journal", folder.PathOf("run.jsonl"));
        await using var silentWriter = await opening.WaitAsync(patience.Token);
        program.Signal(PosixSignal.SIGTERM);
        var report = JsonDocument.Parse(await program.Out.ReadToEndAsync(patience.Token)).RootElement;
        await program.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (program.ExitCode, report.GetProperty("outcome").GetString()));
        Assert.False(File.Exists(folder.PathOf("run.jsonl")));
    }

    [Fact]
    public async Task A_script_with_a_machine_in_hand_stops_it_and_leaves_what_computes_behind()
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1.0 });
        var place = await controller.ListenTcpAsync(0, patience.Token);
        var drawing = NamedPipe.Make(folder.PathOf("drawing.dxf"));
        var opening = NamedPipe.WriterAsync(drawing);
        var script = folder.WithFile("jog.scr", string.Create(CultureInfo.InvariantCulture, $"CNCCONNECT tcp://127.0.0.1:{place.Port}\nCNCTERMINAL\nJGA=1000;BGA\nOPEN\n{drawing}\n"));
        using var program = EngraverProcess.Start("script", script);
        await using var silentWriter = await opening.WaitAsync(patience.Token);
        Assert.True(controller.Status.IsMoving);
        program.Signal(PosixSignal.SIGTERM);
        await program.WaitAsync(patience.Token);

        Assert.Equal(ExitCode.StoppedByOperator, program.ExitCode);
        await controller.WaitUntilAsync(status => !status.IsMoving, patience.Token);
    }

    [Fact]
    public async Task A_signal_ends_a_run_whose_trace_nobody_reads()
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions());
        var place = await controller.ListenTcpAsync(0, patience.Token);
        var drawing = folder.WithFile("line.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n9\n21\n9\n0\nENDSEC\n0\nEOF\n");
        using var program = EngraverProcess.Start(
            "run", drawing, "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}"), "--json", "--trace", NamedPipe.Make(folder.PathOf("trace")), "--journal", folder.PathOf("run.jsonl"));
        Assert.Contains("DXF0003", await program.Error.ReadLineAsync(patience.Token), StringComparison.Ordinal); // The drawing is prepared; next the trace is opened.
        program.Signal(PosixSignal.SIGINT);
        var report = JsonDocument.Parse(await program.Out.ReadToEndAsync(patience.Token)).RootElement;
        await program.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (program.ExitCode, report.GetProperty("outcome").GetString()));
    }

    [Fact]
    public async Task A_second_signal_while_the_machine_brakes_does_not_cut_the_stop_short()
    {
        if (OperatingSystem.IsWindows()) return; // No signals on this system.
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 3.0 });
        var clock = await controller.ListenClockAsync(patience.Token); // The host uses the controller's clock, so that a busy computer does not trip the watchdog.
        var place = await controller.ListenTcpAsync(0, patience.Token);
        var slow = folder.WithFile("slow.json", """{ "accelerationCounts": 10240 }""");
        using var host = EngraverProcess.Start(
            "run", SampleDrawing.PathOf("paper-001"), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}"), "--machine", slow, "--json", "--journal", folder.PathOf("run.jsonl"));
        await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0 && controller.Record[controller.Record.Count - 1].A > 80000, patience.Token);
        host.Signal(PosixSignal.SIGINT);
        await controller.WaitUntilAsync(status => (status.Outputs & Tool) == 0, patience.Token); // It decelerates for two seconds of controller time.
        host.Signal(PosixSignal.SIGINT);
        host.Signal(PosixSignal.SIGTERM);
        var report = JsonDocument.Parse(await host.Out.ReadToEndAsync(patience.Token)).RootElement;
        await host.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (host.ExitCode, report.GetProperty("outcome").GetString()));
        Assert.True(controller.Status.IsIdle);
        Assert.Equal(controller.Record[controller.Record.Count - 1].A, report.GetProperty("finalX").GetInt32());
    }
}
