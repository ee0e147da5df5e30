using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Verbs;

/// <summary><c>engraver jog --hold</c> as a separate process: what stops it, and what stops the machine when the process is killed. The simulated controller
/// uses the clock of its host, and the wall clock after the host has ended.</summary>
public class ContinuousJogTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(120);

    /// <summary>Also on the tool axis.</summary>
    [Theory]
    [InlineData("x+", 10)]
    [InlineData("z+", 4)]
    public async Task A_host_that_is_killed_in_mid_jog_leaves_a_machine_that_brakes_by_itself(string way, int step)
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        using var host = await JoggingAsync(controller, patience.Token, way);

        host.Kill();
        var killed = controller.Status.Sample;
        await host.WaitAsync(patience.Token);
        await controller.WaitUntilAsync(status => status.IsIdle, patience.Token);

        var rows = controller.Record.Snapshot();
        var speeds = rows.Zip(rows.Skip(1)).Where(pair => pair.First.Sample >= killed).ToList();
        var brakes = speeds.First(pair => pair.Second.A + pair.Second.C - pair.First.A - pair.First.C < step - 1).First;
        Assert.InRange(brakes.Sample - killed, 0, 400); // 0.26 s on the controller's clock, plus the time for killing the process.
        Assert.InRange(rows[^1].Sample - brakes.Sample, 1, 60); // 10000 / 256000 s
        Assert.Equal(0, (int)controller.Status.Outputs);
    }

    [Theory]
    [InlineData("enter")]
    [InlineData("end")]
    [InlineData("signal")]
    public async Task Enter_the_end_of_the_input_and_a_signal_brake_it_and_leave_the_controller_as_it_was(string how)
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1 });
        using var host = await JoggingAsync(controller, patience.Token);

        if (how == "enter") await host.In.WriteLineAsync("".AsMemory(), patience.Token);
        if (how == "enter") await host.In.FlushAsync(patience.Token);
        if (how == "end") host.In.Close();
        if (how == "signal") host.Signal(PosixSignal.SIGTERM);
        await host.WaitAsync(patience.Token);

        Assert.Equal(how == "signal" ? ExitCode.StoppedByOperator : ExitCode.Done, host.ExitCode);
        Assert.True(controller.Status.IsIdle);
    }

    /// <returns>Time at which it has reached its speed.</returns>
    private static async Task<EngraverProcess> JoggingAsync(SimulatedController controller, CancellationToken patience, string way = "x+")
    {
        var port = (await controller.ListenTcpAsync(0, patience)).Port;
        var clock = (await controller.ListenClockAsync(patience)).Port; // A busy computer must not count as a slow link.
        var host = EngraverProcess.Start("jog", "--hold", way, "--feed", way == "x+" ? "600" : "300", "--machine", SampleDrawing.MillProfile, "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}"));
        var moves = controller.WaitUntilAsync(status => status.IsMoving, patience);
        if (await Task.WhenAny(moves, host.WaitAsync(patience)) != moves) Assert.Fail($"It ended before it moved: {await host.Error.ReadToEndAsync(patience)}");
        var began = controller.Status.Sample;
        await controller.WaitUntilAsync(status => status.Sample > began + 300, patience);
        return host;
    }
}
