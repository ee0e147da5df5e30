using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Host and simulated controller share one clock, which advances only while the host waits: the same job gives the same result, byte for byte,
/// regardless of delays of the host's tasks.</summary>
[Collection(nameof(DeterministicRunTests))]
[CollectionDefinition(nameof(DeterministicRunTests), DisableParallelization = true)]
public sealed class DeterministicRunTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-same-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task The_same_job_twice_gives_the_same_record_journal_and_trace_also_beside_busy_threads(JobMode mode)
    {
        var first = await RunAsync(mode, MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System, keepsRecord: true));
        using var over = new CancellationTokenSource();
        var others = Enumerable.Range(0, Environment.ProcessorCount * 4).Select(_ => Task.Run(() => SpinUntil(over.Token))).ToArray();
        var beside = await RunAsync(mode, MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System, keepsRecord: true));
        await over.CancelAsync();
        await Task.WhenAll(others);

        AssertSame(first, beside);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task Random_stalls_of_the_hosts_tasks_change_nothing(JobMode mode)
    {
        var (even, _) = await StalledRunAsync(mode, null);
        for (var seed = 1; seed <= 6; seed++)
        {
            var (stalled, stalls) = await StalledRunAsync(mode, new Random(seed));

            Assert.True(stalls > 20);
            AssertSame(even, stalled);
        }
    }

    private static void AssertSame(RunFiles one, RunFiles other)
    {
        Assert.Equal(JobOutcome.Complete, one.Outcome);
        Assert.True(one.Record.Length > 1000 && one.Trace.Length > 1000 && one.Journal.Length > 100);
        Assert.Equal(one.Trace, other.Trace);
        Assert.Equal(one.Journal, other.Journal);
        Assert.Equal(one.Record, other.Record);
    }

    private async Task<(RunFiles Files, int Stalls)> StalledRunAsync(JobMode mode, Random? random)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new ManualTimeProvider(), SerialNumber = 1 });
        var stalls = new Stalls(random);
        var connection = MachineConnection.FromLink("sim:", _ => Task.FromResult<IControllerLink>(stalls.Over(new StreamLink(controller.OpenConnection(), "sim:"))), () => MachineClock.FromSimulator(controller.JoinClock()));
        return (await RunAsync(mode, connection, controller), stalls.Count);
    }

    private async Task<RunFiles> RunAsync(JobMode mode, MachineConnection connection, SimulatedController? controller = null)
    {
        await using var owned = connection;
        var (journal, trace) = (Path.Combine(_folder.FullName, "run.jsonl"), Path.Combine(_folder.FullName, "run.trace"));
        File.Delete(journal);
        var settings = new DrawingSettings();
        var job = JobPreparation.Prepare(new DrawingBuilder().Square(2, 3, 4).Circle(12, 5, 2).Line(15, 0, 18, 1).Line(18, 1, 19, 1.2).Build(), settings, mode.Strategy().Style);
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), mode.Strategy()) { JournalPath = journal, TracePath = trace };

        var report = await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, null, CancellationToken.None);
        using var record = new StringWriter();
        (controller ?? connection.Simulator!).Record.WriteCsv(record);
        return new RunFiles(report.Result.Outcome, record.ToString(), await File.ReadAllTextAsync(journal), await File.ReadAllTextAsync(trace));
    }

    private static void SpinUntil(CancellationToken over)
    {
        while (!over.IsCancellationRequested) Thread.SpinWait(1000);
    }

    private sealed record RunFiles(JobOutcome Outcome, string Record, string Journal, string Trace);

    /// <summary>Delays a task from time to time: it continues later on another thread, after other work of the pool.</summary>
    private sealed class Stalls(Random? random)
    {
        private const int OneIn = 10;

        private bool _hasCommands;

        public int Count { get; private set; }

        /// <summary>The first handle is the job's; the second one is polled concurrently, so that the clock does not define their order on the wire.</summary>
        public IControllerLink Over(IControllerLink link)
        {
            if (_hasCommands) return link;
            _hasCommands = true;
            return new StallingLink(link, this);
        }

        public async Task StallAsync()
        {
            int length;
            lock (this)
            {
                if (random?.Next(OneIn) != 0) return;
                Count++;
                length = random.Next(1, 200);
            }

            for (var i = 0; i < length; i++) await Task.Yield();
            await Task.Run(() => Thread.SpinWait(length * 100));
        }
    }

    private sealed class StallingLink(IControllerLink inner, Stalls stalls) : IControllerLink
    {
        public string Description => inner.Description;

        public SerialLine? Line => inner.Line;

        public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            await stalls.StallAsync();
            await inner.WriteAsync(bytes, cancellation);
        }

        public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
        {
            var count = await inner.ReadAsync(buffer, cancellation);
            await stalls.StallAsync();
            return count;
        }

        public ValueTask DisposeAsync() => inner.DisposeAsync();
    }
}
