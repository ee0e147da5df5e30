using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Journal;

/// <summary>The state found by a run that died is restored by the next one, independent of the name of its journal.</summary>
public sealed class CrashRecoveryTests : IDisposable
{
    private const string OwnersProgram = "#OWNER\n'M\u00E4rz\nEN";

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    private JobOptions First => SimulatedBench.Job with { JournalPath = Path.Combine(_folder.FullName, "first.jsonl"), Address = "tcp://here:23" };

    private JobOptions Second => SimulatedBench.Job with { JournalPath = Path.Combine(_folder.FullName, "second.jsonl"), Address = "tcp://here:23" };

    [Theory]
    [InlineData(JobMode.Stream, JobMode.Stream)]
    [InlineData(JobMode.Calls, JobMode.Program)]
    [InlineData(JobMode.Program, JobMode.Calls)]
    public async Task The_next_run_gives_program_settings_and_number_format_back(JobMode died, JobMode next)
    {
        await using var bench = new SimulatedBench();
        var before = await OwnedAsync(bench);
        await DieAsync(bench, First with { Strategy = died.Strategy() });
        Assert.Contains("M\u00E4rz", before, StringComparison.Ordinal); // byte for byte, in any encoding
        Assert.NotEqual(before, await bench.FingerprintAsync());

        var result = await bench.RunAsync(MotionPrograms.Paper, Second with { Strategy = next.Strategy() });

        Assert.Equal((JobOutcome.Complete, ""), (result.Outcome, string.Join('\n', result.NotRestored)));
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task A_run_that_gives_back_and_dies_too_passes_the_findings_on()
    {
        await using var bench = new SimulatedBench();
        var before = await OwnedAsync(bench);
        await DieAsync(bench, First);
        await DieAsync(bench, Second);

        await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { JournalPath = Path.Combine(_folder.FullName, "third.jsonl"), Address = "tcp://here:23" });

        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task What_was_given_back_once_is_not_given_back_again()
    {
        await using var bench = new SimulatedBench();
        await OwnedAsync(bench);
        await DieAsync(bench, First);
        await bench.RunAsync(MotionPrograms.Paper, Second);
        await bench.DownloadAsync("#NEWER\nEN");
        await bench.SendAsync("VSS=8000");
        var before = await bench.FingerprintAsync();

        await bench.RunAsync(MotionPrograms.Paper, Second);

        Assert.Equal(before, await bench.FingerprintAsync());
        Assert.Contains("givenBack", await File.ReadAllTextAsync(First.JournalPath!), StringComparison.Ordinal);
    }

    /// <summary>Regression: a run that was resumed with a new journal elsewhere reported that the previous program of the controller is unknown, although the
    /// given journal contained it.</summary>
    [Fact]
    public async Task A_run_that_goes_on_with_the_dead_one_gives_back_what_its_journal_tells_wherever_its_own_is()
    {
        await using var bench = new SimulatedBench();
        var before = await OwnedAsync(bench);
        await DieAsync(bench, First);
        var elsewhere = _folder.CreateSubdirectory("elsewhere").FullName;

        var result = await bench.RunAsync(MotionPrograms.Paper, Second with { JournalPath = Path.Combine(elsewhere, "second.jsonl"), ResumedJournal = First.JournalPath });

        Assert.Equal((JobOutcome.Complete, ""), (result.Outcome, string.Join('\n', result.NotRestored)));
        Assert.Equal(before, await bench.FingerprintAsync());
        Assert.Contains("givenBack", await File.ReadAllTextAsync(First.JournalPath!), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Without_the_journal_of_the_dead_run_it_is_said_what_cannot_be_given_back()
    {
        await using var bench = new SimulatedBench();
        await OwnedAsync(bench);
        await DieAsync(bench, First);

        var result = await bench.RunAsync(MotionPrograms.Paper, Second with { Address = "tcp://elsewhere:23" });

        Assert.Contains("no journal beside this one", Assert.Single(result.NotRestored), StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static async Task<string> OwnedAsync(SimulatedBench bench)
    {
        await bench.DownloadAsync(OwnersProgram);
        await bench.SendAsync("VR 0.3", "VF 8.2", "VSS=6000", "SPA=1234", "ACB=102400", "CAT", "CW 2", "MOA");
        return await bench.FingerprintAsync();
    }

    /// <summary>The host ends in the middle of the cut; its last line is incomplete.</summary>
    private static async Task DieAsync(SimulatedBench bench, JobOptions options)
    {
        var dead = false;
        await using (var session = await bench.OpenAsync(opened: _ => { if (dead) throw new IOException("The host is dead."); }))
        {
            var die = new CancelWhen(progress => progress.X > 50000, () =>
            {
                dead = true;
                bench.Controller.DropConnections();
            });
            await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, options, die, CancellationToken.None);
        }

        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
        var lines = await File.ReadAllLinesAsync(options.JournalPath!);
        await File.WriteAllTextAsync(options.JournalPath!, string.Join('\n', lines[..^1]) + "\n{\"kind\":\"pro");
    }
}
