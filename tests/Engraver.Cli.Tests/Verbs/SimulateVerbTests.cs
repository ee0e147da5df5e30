using System.Runtime.InteropServices;

namespace Engraver.Cli.Tests.Verbs;

public class SimulateVerbTests
{
    [Theory]
    [InlineData(PosixSignal.SIGINT)]
    [InlineData(PosixSignal.SIGTERM)]
    public async Task It_serves_until_a_signal_and_then_ends_with_exit_0(PosixSignal signal)
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate");

        Assert.Matches("^listening tcp://127\\.0\\.0\\.1:[0-9]+$", await simulate.LineAsync("listening ", patience.Token));
        simulate.Signal(signal);
        await simulate.WaitAsync(patience.Token);
        Assert.Equal(ExitCode.Done, simulate.ExitCode);
    }

    [Fact]
    public async Task An_interrupt_reaches_a_simulator_that_a_script_started_in_the_background()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.StartInBackground("simulate", "--tcp", "0", "--speed", "max");

        await simulate.LineAsync("listening ", patience.Token);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);
        Assert.Equal(ExitCode.Done, simulate.ExitCode);
    }

    [Fact]
    public async Task A_port_that_is_taken_is_exit_4_with_one_sentence()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var first = EngraverProcess.Start("simulate");
        var port = (await first.LineAsync("listening ", patience.Token)).Split(':')[^1];
        var second = await CliRun.Of("simulate", "--tcp", port);

        Assert.Equal(ExitCode.LinkLost, second.ExitCode);
        Assert.Single(second.Error.TrimEnd().Split('\n'));
    }
}
