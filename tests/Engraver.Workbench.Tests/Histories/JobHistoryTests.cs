using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Histories;

/// <summary>The index of jobs: complete files, concurrent writers, a limited number of entries, and invalid files are moved aside.</summary>
public sealed class JobHistoryTests : IDisposable
{
    private static readonly DateTimeOffset s_now = new(2026, 11, 23, 9, 0, 0, TimeSpan.Zero);
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-history-");

    private string Index => Path.Combine(_folder.FullName, "history");

    [Fact]
    public void An_entry_comes_back_with_every_field_and_its_settings()
    {
        var settings = new DrawingSettings { Layers = ["A"], MaxErrorMm = 0.003, Machine = MachineProfile.Default with { FeedMmPerMinute = 321.0 } };
        var entry = Entry("part.dxf", s_now, settings) with { Kind = "run", Mode = "calls", Address = "sim:", Outcome = "deviated", Sentence = "It left the path.", Seconds = 1.5, PlannedSeconds = 1.25, MaxDeviation = 0.1, MissingLength = 2.0, Journal = "/j", Report = "/r", Checks = [new(true, true, "Look.")] };
        var (kept, failure) = new JobHistory(Index).Add(entry);
        var back = Assert.Single(new JobHistory(Index).Refresh().Entries);

        Assert.Null(failure);
        Assert.Equal(kept.Id, back.Id);
        Assert.Equal(entry.Checks, back.Checks);
        Assert.Equal(entry with { Id = kept.Id, Checks = null, Settings = back.Settings, Profile = back.Profile, Options = back.Options }, back with { Checks = null });
        Assert.Equal((321.0, 0.003, "A"), (back.ToSettings(MachineFamilies.Standard).Machine.FeedMmPerMinute, back.ToSettings(MachineFamilies.Standard).MaxErrorMm, Assert.Single(back.ToSettings(MachineFamilies.Standard).Layers!)));
        Assert.Equal(SettingValues.Of(settings), SettingValues.Of(back.ToSettings(MachineFamilies.Standard)));
    }

    [Fact]
    public void The_newest_is_the_first_and_is_found_by_number_name_and_word()
    {
        var history = new JobHistory(Index);
        foreach (var (name, hours) in new[] { ("late.dxf", 2), ("early.dxf", 0), ("middle.dxf", 1) }) history.Add(Entry(name, s_now.AddHours(hours)));
        var reading = new JobHistory(Index).Refresh();

        Assert.Equal(["late.dxf", "middle.dxf", "early.dxf"], reading.Entries.Select(entry => Path.GetFileName(entry.Drawing)));
        Assert.Same(reading.Entries[1], reading.Find("2"));
        Assert.Same(reading.Entries[2], reading.Find(reading.Entries[2].Id));
        Assert.All(["0", "4", "-1", "x", ""], word => Assert.Null(reading.Find(word)));
        Assert.Equal("early.dxf", Path.GetFileName(Assert.Single(reading.Filter("EARLY").Entries).Drawing));
        Assert.Equal("middle.dxf", Path.GetFileName(Assert.Single(reading.Filter("2026-11-23 10:00").Entries).Drawing));
        Assert.Empty(reading.Filter("nothing of the kind").Entries);
    }

    [Fact]
    public void A_run_stands_as_begun_until_it_ends_and_one_that_did_nothing_leaves_nothing()
    {
        var (history, failures) = (new JobHistory(Index), new List<string>());
        using (var open = new PendingRun(history, Entry("killed.dxf", s_now) with { Outcome = "begun" }, failures.Add))
        {
            Assert.Equal("begun", Assert.Single(new JobHistory(Index).Refresh().Entries).Outcome);
            open.End(Entry("killed.dxf", s_now) with { Outcome = "complete" });
            Assert.Throws<InvalidOperationException>(() => open.End(Entry("killed.dxf", s_now)));
        }

        Assert.Equal("complete", Assert.Single(new JobHistory(Index).Refresh().Entries).Outcome);
        new PendingRun(history, Entry("nothing.dxf", s_now) with { Outcome = "begun" }, failures.Add).Dispose();
        Assert.Equal("killed.dxf", Path.GetFileName(Assert.Single(new JobHistory(Index).Refresh().Entries).Drawing));
        Assert.Single(history.Snapshot.Entries);
        Assert.Empty(failures);
    }

    [Fact]
    public async Task A_pipe_in_the_folder_is_no_entry_and_nobody_waits_for_it()
    {
        new JobHistory(Index).Add(Entry("part.dxf", s_now));
        NamedPipe.Make(Path.Combine(Index, "20000101-000000-000-pipe.json"));
        var reading = await Task.Run(() => new JobHistory(Index).Refresh()).WaitAsync(TimeSpan.FromSeconds(30));

        Assert.Equal("part.dxf", Path.GetFileName(Assert.Single(reading.Entries).Drawing));
        Assert.Empty(reading.Findings);
    }

    [Fact]
    public async Task Several_writers_at_a_time_lose_nothing()
    {
        const int Writers = 4;
        const int Each = 25;
        await Task.WhenAll(Enumerable.Range(0, Writers).Select(writer => Task.Run(() =>
        {
            var history = new JobHistory(Index);
            for (var i = 0; i < Each; i++) Assert.Null(history.Add(Entry(string.Create(CultureInfo.InvariantCulture, $"{writer}-{i}.dxf"), s_now)).Failure);
        })));
        var reading = new JobHistory(Index).Refresh();

        Assert.Empty(reading.Findings);
        Assert.Equal(Writers * Each, reading.Entries.Select(entry => entry.Drawing).Distinct().Count());
        Assert.Empty(Directory.EnumerateFiles(Index, "*.tmp"));
    }

    [Fact]
    public void The_oldest_go_when_there_are_too_many()
    {
        var history = new JobHistory(Index, maxEntries: 3);
        for (var day = 0; day < 5; day++) history.Add(Entry(string.Create(CultureInfo.InvariantCulture, $"{day}.dxf"), s_now.AddDays(day)));

        Assert.Equal(["4.dxf", "3.dxf", "2.dxf"], new JobHistory(Index).Refresh().Entries.Select(entry => Path.GetFileName(entry.Drawing)));
    }

    [Theory]
    [InlineData("")]
    [InlineData("{\"date\": 7}")]
    [InlineData("null")]
    [InlineData("{\"version\": 1, \"date\": \"2026-11-23T09:00:00Z\"")]
    public void What_is_no_entry_is_kept_aside_and_told_once_and_the_others_are_read(string text)
    {
        var history = new JobHistory(Index);
        history.Add(Entry("good.dxf", s_now));
        File.WriteAllText(Path.Combine(Index, "20261123-080000-000-bad.json"), text);
        var reading = history.Refresh();

        Assert.Equal("good.dxf", Path.GetFileName(Assert.Single(reading.Entries).Drawing));
        Assert.Contains("20261123-080000-000-bad.json", Assert.Single(reading.Findings), StringComparison.Ordinal);
        Assert.Equal(text, File.ReadAllText(Path.Combine(Index, "unreadable", "20261123-080000-000-bad.json")));
        Assert.Empty(history.Refresh().Findings);
    }

    [Fact]
    public void An_entry_of_a_later_version_stays_where_it_is()
    {
        var history = new JobHistory(Index);
        var kept = history.Add(Entry("a.dxf", s_now) with { Version = 2 }).Entry;

        Assert.Empty(new JobHistory(Index).Refresh().Entries);
        Assert.Contains("version 2", Assert.Single(new JobHistory(Index).Refresh().Findings), StringComparison.Ordinal);
        Assert.True(File.Exists(Path.Combine(Index, kept.Id + ".json")));
    }

    [Fact]
    public void An_entry_of_a_later_version_stays_also_where_it_has_another_form()
    {
        Directory.CreateDirectory(Index);
        var later = Path.Combine(Index, "20261123-080000-000-later.json");
        File.WriteAllText(later, "{\"version\": 2, \"when\": 7}");

        Assert.Contains("version 2", Assert.Single(new JobHistory(Index).Refresh().Findings), StringComparison.Ordinal);
        Assert.True(File.Exists(later));
    }

    [Theory]
    [InlineData("max-error", "0")]
    [InlineData("max-error", "-5")]
    [InlineData("join-tolerance", "-1")]
    [InlineData("tool-diameter", "-0.1")]
    [InlineData("cut", "-7")]
    [InlineData("cut", "99999999999999999")]
    [InlineData("cut", "0.5")]
    public void A_damaged_setting_is_none_to_run_with(string key, string word)
    {
        var entry = Entry("a.dxf", s_now);

        Assert.Throws<FormatException>(() => (entry with { Settings = new Dictionary<string, string>(entry.Settings) { [key] = word } }).ToSettings(MachineFamilies.Standard));
    }

    [Fact]
    public void An_entry_without_a_drawing_is_none()
    {
        new JobHistory(Index).Add(Entry("a.dxf", s_now) with { Drawing = "" });

        Assert.Contains("does not name a drawing", Assert.Single(new JobHistory(Index).Refresh().Findings), StringComparison.Ordinal);
    }

    [Fact]
    public void An_index_that_cannot_be_written_is_said_and_without_a_folder_it_lives_in_memory()
    {
        File.WriteAllText(Index, "a file where the folder should be");
        var (_, failure) = new JobHistory(Index).Add(Entry("a.dxf", s_now));
        var memory = new JobHistory(null);
        memory.Add(Entry("a.dxf", s_now));

        Assert.NotNull(failure);
        Assert.Equal("a.dxf", Path.GetFileName(Assert.Single(memory.Snapshot.Entries).Drawing));
        Assert.Single(memory.Refresh().Entries);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static HistoryEntry Entry(string name, DateTimeOffset date, DrawingSettings? settings = null) => HistoryEntry.OfPost(new DrawingBuilder { Unit = settings?.Unit ?? LengthUnit.AssumedMillimetres }.Build() with { FileName = Path.Combine(RepositoryFolder.Samples, name) }, settings ?? new DrawingSettings(), "galil", PostedProgram.NoOptions, null, date);
}
