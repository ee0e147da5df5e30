using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The same job cuts at the same machine position regardless of how the previous one ended, checked by the simulator's counts. The hosts are
/// processes, which can be killed; the origin is at an unlikely position.</summary>
public class RepeatedOriginTests
{
    private const int Tool = 1;
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(180);

    /// <summary>The fast subset runs one mode from the console (<c>WorkOriginTests</c> run all in the session), the full run all modes from both
    /// programs.</summary>
    public static TheoryData<string> ConsoleModes => TestExtent.IsFull ? ["stream", "calls", "program"] : ["program"];

    public static TheoryData<string> ScriptModes => ["Stream", "Calls", "Program"];

    [Theory]
    [MemberData(nameof(ConsoleModes))]
    public async Task A_job_of_the_console_is_cut_in_the_same_place_again_after_a_stop_and_after_a_killed_host(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var address = await AddressAsync(controller, patience.Token);
        string[] words = ["run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--mode", mode, "--json", "--journal", folder.PathOf("run.jsonl")];
        await OriginAtAsync(address, "12.5,-7.25");

        var first = await CutAsync(controller, () => CliRun.RunAsync(words));
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync(words)));
        await InterruptedAsync(controller, words, host => host.Kill(), patience.Token);
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync(words)));
        await InterruptedAsync(controller, words, host => host.Signal(PosixSignal.SIGINT), patience.Token);
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync(words)));
        Assert.Equal((12500L, -7250L), (first.FinalX, first.FinalY));
    }

    /// <summary>A script uses the same session as the desktop, so a killed script represents a killed desktop.</summary>
    [FullRunTheory]
    [MemberData(nameof(ScriptModes))]
    public async Task So_is_a_job_of_the_desktops_commands(string mode)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var address = await AddressAsync(controller, patience.Token);
        var script = folder.PathOf("job.scr");
        await File.WriteAllTextAsync(script, $"OPEN\n{SampleDrawing.PathOf("paper-001")}\nCNCCONNECT\n{address}\nCNCARM\n{mode}\nCNCRUN\n", patience.Token);
        await OriginAtAsync(address, "12.5,-7.25");

        var first = await CutAsync(controller, () => CliRun.RunAsync("script", script));
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync("script", script)));
        await InterruptedAsync(controller, ["script", script], host => host.Kill(), patience.Token);
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync("script", script)));
        await InterruptedAsync(controller, ["script", script], host => host.Signal(PosixSignal.SIGINT), patience.Token);
        Assert.Equal(first, await CutAsync(controller, () => CliRun.RunAsync("script", script)));
        Assert.Equal((12500L, -7250L), (first.FinalX, first.FinalY));
    }

    private static async Task<string> AddressAsync(SimulatedController controller, CancellationToken cancellation)
    {
        var clock = (await controller.ListenClockAsync(cancellation)).Port;
        var port = (await controller.ListenTcpAsync(0, cancellation)).Port;
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
    }

    private static async Task OriginAtAsync(string address, string place)
    {
        var moved = await CliRun.RunAsync("goto", place, "--machine-position", "--connect", address);
        Assert.True(moved.ExitCode == ExitCode.Done, moved.Error);
        var set = await CliRun.RunAsync("zero", "--connect", address);
        Assert.True(set.ExitCode == ExitCode.Done, set.Error);
    }

    /// <summary>The host is ended in the middle of a cut; the controller comes to rest on its own or by the stop, away from the end of the job.</summary>
    private static async Task InterruptedAsync(SimulatedController controller, string[] words, Action<EngraverProcess> end, CancellationToken cancellation)
    {
        using var host = EngraverProcess.Start(words);
        await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, cancellation);
        end(host);
        await host.WaitAsync(cancellation);
        await controller.WaitUntilAsync(status => !status.IsMoving && (status.Outputs & Tool) == 0, cancellation);
        var last = controller.Record[controller.Record.Count - 1];
        Assert.NotEqual((12500L, -7250L), ((long)last.A, (long)last.B));
    }

    /// <summary>Bounds of the cut of this run and its final position; counts of the controller.</summary>
    private static async Task<CutExtents> CutAsync(SimulatedController controller, Func<Task<CliRun>> run)
    {
        var before = controller.Record.Count;
        var done = await run();
        Assert.True(done.ExitCode == ExitCode.Done, done.Out + done.Error);
        var rows = controller.Record.Snapshot().Skip((int)before).ToList();
        var cut = rows.Where(row => (row.Outputs & Tool) != 0).ToList();
        return new CutExtents((long)cut.Min(row => row.A), (long)cut.Min(row => row.B), (long)cut.Max(row => row.A), (long)cut.Max(row => row.B), (long)rows[^1].A, (long)rows[^1].B);
    }

    private sealed record CutExtents(long MinX, long MinY, long MaxX, long MaxY, long FinalX, long FinalY);
}
