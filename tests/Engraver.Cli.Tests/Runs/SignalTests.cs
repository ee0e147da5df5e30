using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Signals, at places that a verb does not leave by itself.</summary>
public class SignalTests
{
    private const byte Tool = 1;
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(2);

    [Theory]
    [InlineData(PosixSignal.SIGINT, "info")]
    [InlineData(PosixSignal.SIGTERM, "sequence")]
    [InlineData(PosixSignal.SIGTERM, "plan")]
    public async Task A_signal_ends_a_verb_that_hears_nothing(PosixSignal signal, string verb)
    {
        if (OperatingSystem.IsWindows()) return; // no signals
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        var drawing = NamedPipe.Make(folder.PathOf("drawing.dxf"));
        var opening = NamedPipe.WriterAsync(drawing);
        using var program = EngraverProcess.Start(verb, drawing, "--json");
        await using var silentWriter = await opening.WaitAsync(patience.Token); // from here on the program waits for the rest of the drawing
        program.Signal(signal);
        var (said, why) = (await program.Out.ReadToEndAsync(patience.Token), await program.Error.ReadToEndAsync(patience.Token));
        await program.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "", "engraver: Stopped by the operator."), (program.ExitCode, said, why.Trim()));
    }

    [Fact]
    public async Task A_run_that_is_stopped_before_it_is_prepared_prints_its_one_object()
    {
        if (OperatingSystem.IsWindows()) return; // no signals
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
    public async Task A_second_signal_while_the_machine_brakes_does_not_cut_the_stop_short()
    {
        if (OperatingSystem.IsWindows()) return; // no signals
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 2.5 }); // below the rate at which a host winds its watchdog up
        var place = await controller.ListenTcpAsync(0, patience.Token);
        var slow = folder.WithFile("slow.json", """{ "accelerationCounts": 10240 }""");
        using var host = EngraverProcess.Start(
            "run", SampleDrawing.PathOf("paper-001"), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}"), "--machine", slow, "--json", "--journal", folder.PathOf("run.jsonl"));
        await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0 && controller.Record[controller.Record.Count - 1].A > 80000, patience.Token);
        host.Signal(PosixSignal.SIGINT);
        await controller.WaitUntilAsync(status => (status.Outputs & Tool) == 0, patience.Token); // it brakes for two seconds of the controller
        host.Signal(PosixSignal.SIGINT);
        host.Signal(PosixSignal.SIGTERM);
        var report = JsonDocument.Parse(await host.Out.ReadToEndAsync(patience.Token)).RootElement;
        await host.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (host.ExitCode, report.GetProperty("outcome").GetString()));
        Assert.True(controller.Status.IsIdle);
        Assert.Equal(controller.Record[controller.Record.Count - 1].A, report.GetProperty("finalX").GetInt32());
    }
}
