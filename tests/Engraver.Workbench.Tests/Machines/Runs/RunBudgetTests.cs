using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>The files of old runs are limited; runs that may still be needed are not deleted.</summary>
public sealed class RunBudgetTests : IDisposable
{
    private const string Found = """{"kind":"found","address":"sim:","controller":"DMC2143","state":{"wire":{},"motion":[],"motorsOff":""}}""";
    private const string Job = """{"kind":"job","drawing":"part.dxf","controller":"DMC2143","mode":"stream","segmentCount":4,"startX":0,"startY":0,"frameX":0,"frameY":0,"startedAt":"2026-01-01T00:00:00+00:00","dryRun":false}""";
    private const string Complete = """{"kind":"end","outcome":"complete","sentence":"","segmentsExecuted":4,"x":0,"y":0,"time":1,"leftAsFound":true,"cut":4,"along":0}""";
    private const string Stopped = """{"kind":"end","outcome":"stopped","sentence":"","segmentsExecuted":2,"x":0,"y":0,"time":1,"leftAsFound":true,"cut":2,"along":0}""";
    private const string Deviated = """{"kind":"end","outcome":"deviated","sentence":"","segmentsExecuted":2,"x":0,"y":0,"time":1,"leftAsFound":true,"cut":2,"along":0}""";

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-runs-");
    private int _day;

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void The_oldest_runs_go_with_all_their_files_until_the_rest_fits()
    {
        for (var run = 1; run <= 5; run++) Keep($"part{run}", Found, Job, Complete);

        Assert.InRange(RunBudget.UsedIn(_folder.FullName), 5.0, 5.1);
        RunBudget.MakeRoom(_folder.FullName, 6);
        Assert.Equal(10, _folder.GetFiles().Length);
        RunBudget.MakeRoom(_folder.FullName, 3);

        Assert.Equal(["part4.jsonl", "part4.jsonl.wire", "part5.jsonl", "part5.jsonl.wire"], _folder.GetFiles().Select(file => file.Name).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void A_run_that_is_under_way_or_can_be_resumed_stays_however_old_it_is()
    {
        Keep("underway", Found, Job);
        Keep("stopped", Found, Job, Stopped);
        Keep("unknown", "no journal");
        Keep("deviated", Found, Job, Deviated);
        Keep("later-gone", Found, Job, Stopped, ResumedBy("gone.jsonl"));
        Keep("complete", Found, Job, Complete);
        Keep("resumed", Found, Job, Stopped, ResumedBy("stopped.jsonl"));
        File.WriteAllBytes(Path.Combine(_folder.FullName, "notes.jsonl.bak"), new byte[1_000_000]);
        File.WriteAllBytes(Path.Combine(_folder.FullName, "beginning.jsonl.wire"), new byte[1_000_000]);

        RunBudget.MakeRoom(_folder.FullName, 1);

        Assert.Equal(["deviated.jsonl", "later-gone.jsonl", "stopped.jsonl", "underway.jsonl", "unknown.jsonl"], _folder.GetFiles("*.jsonl").Select(file => file.Name).Order(StringComparer.Ordinal));
        Assert.True(File.Exists(Path.Combine(_folder.FullName, "notes.jsonl.bak")) && File.Exists(Path.Combine(_folder.FullName, "beginning.jsonl.wire")));
    }

    [Fact]
    public void A_folder_that_is_not_there_takes_no_room()
    {
        var gone = Path.Combine(_folder.FullName, "gone");
        RunBudget.MakeRoom(gone, 1);

        Assert.Equal(0.0, RunBudget.UsedIn(gone));
    }

    private string ResumedBy(string name) => $$"""{"kind":"resumed","by":"{{Path.Combine(_folder.FullName, name)}}"}""";

    private void Keep(string name, params string[] lines)
    {
        var journal = Path.Combine(_folder.FullName, name + ".jsonl");
        File.WriteAllLines(journal, lines);
        File.WriteAllBytes(journal + ".wire", new byte[1_000_000]);
        foreach (var file in new[] { journal, journal + ".wire" }) File.SetLastWriteTimeUtc(file, new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc).AddDays(_day));
        _day++;
    }
}
