using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs.Wires;

/// <summary>What a job sends is compared byte for byte with what it sent before: <c>expected.txt</c> holds the digest of every run. A change of the job loop
/// that is not meant to change what a controller receives leaves this file as it is.</summary>
/// <remarks>Where a digest differs, the bytes of all runs are in <c>artifacts/wires</c>. Run the tests with ENGRAVER_UPDATE_GOLDEN=1 before and after the
/// change and compare the two folders.</remarks>
public sealed class JobWireTests : IDisposable
{
    private static readonly string s_expected = Path.Combine(RepositoryFolder.Root, "tests", "Engraver.Galil.Tests", "Jobs", "Wires", "expected.txt");

    private readonly string _folder = Directory.CreateTempSubdirectory("engraver-wires-").FullName;

    [Fact]
    public async Task Every_byte_of_every_job_is_the_one_that_was_sent_before()
    {
        var digests = new StringBuilder();
        foreach (var mode in (JobMode[])[JobMode.Stream, JobMode.Calls, JobMode.Program])
        {
            foreach (var one in WireCase.Jobs) digests.Append(await InterruptedAsync(one, mode)).Append('\n');
            foreach (var one in WireCase.Faults) digests.Append(await FaultAsync(one, mode)).Append('\n');
        }

        foreach (var one in HandCase.All) digests.Append(await ByHandAsync(one)).Append('\n');

        GoldenFile.Check(s_expected, digests.ToString());
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    /// <summary>Runs the job until it is stopped, and then the rest of it.</summary>
    private async Task<string> InterruptedAsync(WireCase one, JobMode mode)
    {
        await using var bench = new WireBench(one.Baud, one.ProgramLines);
        var program = one.Program(mode);
        var journal = Path.Combine(_folder, $"{one.Name}.{mode}.jsonl");
        var first = await RunAsync(bench, one, program, Options(bench, one, mode, journal));
        JobResult second;
        await using (var session = await bench.OpenAsync())
        {
            var found = await ResumeFinder.FindAsync(session.Commands, program, mode, journal, CancellationToken.None);
            bench.TakeNewControl();
            var options = one.With(SimulatedBench.Job) with { Strategy = mode.Strategy(), Address = "bench", JournalPath = journal + ".rest", ResumedJournal = journal, From = found.Place, LeadIn = 300.0 + found.Doubt, Frame = found.Frame, HeightOfCut = found.HeightOfCut, Control = bench.Control };
            second = await JobRunner.RunAsync(program, session, options, null, CancellationToken.None);
        }

        return Kept($"{mode} {one.Name}", bench.Wire, first, second);
    }

    private async Task<string> FaultAsync(WireCase one, JobMode mode)
    {
        await using var bench = new WireBench(one.Baud, harm: one.Harm);
        return Kept($"{mode} {one.Name}", bench.Wire, await RunAsync(bench, one, one.Program(mode), Options(bench, one, mode, Path.Combine(_folder, $"{one.Name}.{mode}.jsonl"))));
    }

    private static async Task<string> ByHandAsync(HandCase one)
    {
        await using var bench = new WireBench(one.Baud, switches: one.Switches);
        await using var session = await bench.OpenAsync();
        return Kept(one.Name, bench.Wire, await one.RunAsync(bench, session));
    }

    private static JobOptions Options(WireBench bench, WireCase one, JobMode mode, string journal) =>
        one.With(SimulatedBench.Job) with { Strategy = mode.Strategy(), Address = "bench", JournalPath = journal, Control = bench.Control };

    private static async Task<JobResult> RunAsync(WireBench bench, WireCase one, MotionProgram program, JobOptions options)
    {
        await using var session = await bench.OpenAsync();
        return await JobRunner.RunAsync(program, session, options, new WireOperator(bench, one.Steps), bench.Stop.Token);
    }

    /// <summary>The line of a run, and its bytes in the folder.</summary>
    private static string Kept(string name, WireRecord wire, params IReadOnlyList<JobResult> results)
    {
        var folder = Path.Combine(RepositoryFolder.Root, "artifacts", "wires");
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, name.Replace(' ', '-') + ".txt"), wire.Text + "\n" + string.Join('\n', results.Select(result => $"= {result.Outcome} {result.Place} {result.FinalPosition} {result.Holds} {result.PositionDoubt} {result.Message}")) + "\n");
        return $"{name}: {string.Join(", ", results.Select(result => $"{result.Outcome} at {result.SegmentsExecuted}"))}: {wire.Digest}";
    }
}
