using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Another program uses the machine: every verb names it and ends with exit 3, and nothing moves.</summary>
public sealed class MachineInUseTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(120);

    [Fact]
    public async Task Every_verb_that_needs_the_machine_ends_with_exit_3()
    {
        using var patience = new CancellationTokenSource(s_patience);
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var clock = (await controller.ListenClockAsync(patience.Token)).Port;
        var port = (await controller.ListenTcpAsync(0, patience.Token)).Port;
        var address = string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
        var script = folder.WithFile("connect.scr", $"CNCCONNECT {address}\n");
        await using var other = new MachineSession(TimeProvider.System, MachineMemories.FolderIn(null));
        Assert.True(ControllerAddress.TryParse(address, out var parsed));
        await other.Connection.ConnectAsync(parsed, patience.Token);
        string[] drawing = [SampleDrawing.PathOf("paper-001"), "--connect", address];

        foreach (var words in (string[][])[
            ["status", "--connect", address], ["goto", "1,1", "--machine-position", "--connect", address], ["jog", "--x", "1", "--connect", address], ["zero", "--connect", address],
            ["origin", "G55", "--connect", address], ["motors", "on", "--connect", address], ["home", "--connect", address], ["frame", .. drawing], ["run", .. drawing], ["script", script]])
        {
            var run = await CliRun.RunAsync(words);

            Assert.Equal((words[0], ExitCode.Refused), (words[0], run.ExitCode));
            Assert.Contains("is in use by", run.Error + run.Out, StringComparison.Ordinal);
        }

        Assert.All(controller.Record.Snapshot(), sample => Assert.Equal((0, 0), (sample.A, sample.B)));
    }
}
