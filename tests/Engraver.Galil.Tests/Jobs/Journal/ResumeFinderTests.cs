using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs.Journal;

/// <summary>The watchdog stores in the controller where it stopped the machine: a journal with a later position is not used.</summary>
public sealed class ResumeFinderTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-resume-");

    [Theory]
    [InlineData(0, 0, "")]
    [InlineData(90000, 90000, "but the controller counted 0 segments and")]
    [InlineData(90000, 0, "the position in the same line")]
    public async Task A_last_place_that_the_controller_contradicts_is_refused_with_both(int along, int x, string reason)
    {
        await using var bench = new SimulatedBench();
        var journal = Path.Combine(_folder.FullName, "dead.jsonl");
        var program = MotionPrograms.LongLine(200000);
        await DieAsync(bench, program, SimulatedBench.Job with { JournalPath = journal });
        await File.WriteAllLinesAsync(journal, [.. (await File.ReadAllLinesAsync(journal)).Where(line => !line.Contains("\"kind\":\"end\"", StringComparison.Ordinal)).Select(line => Older(line, along, x))]);
        await using var session = await bench.OpenAsync();

        var found = await ResumeFinder.FindAsync(session.Commands, program, JobMode.Stream, journal, CancellationToken.None);

        Assert.Equal(reason.Length == 0, found.Refusal is null);
        Assert.Contains(reason, found.Refusal ?? "", StringComparison.Ordinal);
        if (reason.Length == 0) Assert.InRange(found.Place.Along, 50_000.0 - 1_000.0, 120_000.0);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    /// <summary>A line as written by an older version, with other numbers in the record of a cut.</summary>
    private static string Older(string line, int along, int x)
    {
        var plain = Regex.Replace(line, ",\"n\":[0-9]+,\"sum\":\"[0-9a-f]{8}\"}$", "}");
        return Regex.IsMatch(plain, "\"along\":[1-9]") ? More(More(plain, "along", along), "x", x) : plain;
    }

    private static string More(string line, string name, int more) =>
        Regex.Replace(line, $"(\"{name}\":)([0-9.]+)", found => found.Groups[1].Value + (double.Parse(found.Groups[2].Value, CultureInfo.InvariantCulture) + more).ToString(CultureInfo.InvariantCulture));

    /// <summary>The host ends in the middle of the cut.</summary>
    private static async Task DieAsync(SimulatedBench bench, MotionProgram program, JobOptions options)
    {
        var dead = false;
        await using (var session = await bench.OpenAsync(opened: _ => { if (dead) throw new IOException("The host is dead."); }))
        {
            var die = new CancelWhen(progress => progress.X > 60000, () =>
            {
                dead = true;
                bench.Controller.DropConnections();
            });
            await JobRunner.RunAsync(program, session, options, die, CancellationToken.None);
        }

        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
    }
}
