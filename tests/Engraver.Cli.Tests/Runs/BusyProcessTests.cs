using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A job concurrently with other work of the same process: opening a drawing, tiles, a plan. The controller's watchdog trips after one second, so the
/// heartbeat must not wait for a free pool thread.</summary>
[Collection(nameof(BusyProcess))]
public class BusyProcessTests
{
    /// <summary>The fast subset runs the mode that needs the host continuously.</summary>
    public static TheoryData<string> Modes => TestExtent.IsFull ? ["stream", "program"] : ["stream"];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_job_reaches_its_end_while_more_work_waits_than_the_machine_has_cores(string mode)
    {
        using var folder = new TemporaryFolder();
        using var over = new CancellationTokenSource();
        await using var controller = new SimulatedController(new SimulatorOptions());
        var drawing = folder.WithFile("line.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n30\n21\n0\n0\nENDSEC\n0\nEOF\n"); // One and a half seconds: the watchdog trips after one.
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        var others = Enumerable.Range(0, Environment.ProcessorCount * 4).Select(_ => Task.Run(() => WorkUntil(over.Token))).ToArray();
        var run = await CliRun.RunAsync("run", drawing, "--connect", "tcp://" + place, "--mode", mode, "--journal", folder.PathOf("run.jsonl"));
        await over.CancelAsync();
        var work = await Task.WhenAll(others);

        Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        Assert.All(work, rounds => Assert.True(rounds > 0));
    }

    private static long WorkUntil(CancellationToken over)
    {
        var rounds = 0L;
        while (!over.IsCancellationRequested)
        {
            rounds++;
            Thread.SpinWait(1000);
        }

        return rounds;
    }
}

/// <summary>Tests that keep every core busy on purpose run in isolation.</summary>
[CollectionDefinition(nameof(BusyProcess), DisableParallelization = true)]
public sealed class BusyProcess;
