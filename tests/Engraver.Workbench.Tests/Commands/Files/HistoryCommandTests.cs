using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Files;

public class HistoryCommandTests
{
    [Fact]
    public async Task Runs_simulations_and_programs_are_in_it_and_one_is_opened_with_its_settings_again()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf", "CNCMAXERR", "0.004", "CNCFEED", "654", "CNCSIM", "POST", "Galil", "job.dmc", "AGIEPOST", "Exact", "job.agie", "EXPORT", "other.dmc", "EXPORT", "picture.svg");
        await talk.TypeAsync("CNCCONNECT", "sim:", "CNCARM", "Calls", "CNCRUN");
        var entries = talk.Session.History.Refresh().Entries;

        Assert.Equal(["run", "post", "post", "post", "simulation"], entries.Select(entry => entry.Kind));
        Assert.Equal(["galil-calls", "galil", "agie", "galil", "galil"], entries.Select(entry => entry.Target));
        Assert.Equal(["complete", "written", "written", "written", "complete"], entries.Select(entry => entry.Outcome));
        Assert.Equal((talk.PathOf("job.dmc"), "calls"), (entries[3].Program, entries[0].Mode));
        Assert.True(File.Exists(entries[0].Journal) && entries[0].Journal != entries[4].Journal);
        Assert.Contains(entries[0].Checks!, check => check.Sentence.StartsWith("The drawing has no certificate", StringComparison.Ordinal));
        Assert.InRange(entries[4].MaxDeviation!.Value, 0.0, 0.01);

        await talk.TypeAsync("CNCMAXERR", "0.001", "CNCFEED", "600", "CNCDISCONNECT", "CLOSE");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("HISTORY", "Rerun", "5"));
        Assert.Equal((0.004, 654.0, "part.dxf"), (talk.State.Settings.MaxErrorMm, talk.State.Settings.Machine.FeedMmPerMinute, Path.GetFileName(talk.State.Drawing!.FileName)));
        await talk.TypeAsync("CNCMAXERR", "0.001");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("HISTORY", "Open", entries[4].Id));
        Assert.Equal(0.001, talk.State.Settings.MaxErrorMm);
    }

    [Fact]
    public async Task It_is_listed_searched_and_says_what_it_has_not()
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HISTORY", ""));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HISTORY", "Rerun"));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "POST", "Galil", "a.dmc", "OPEN", CommandTestSession.Sample("gasket.dxf"), "POST", "Galil", "b.dmc", "HISTORY", "Search", "paper");

        Assert.Contains("   2  ", talk.Said, StringComparison.Ordinal);
        Assert.Contains("paper-001.dxf  post galil  written", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("gasket.dxf  post", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("HISTORY", "List");
        Assert.Contains("gasket.dxf  post galil  written", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HISTORY", "Search", "nothing of the kind"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HISTORY", "Open", "3"));
    }

    [Fact]
    public async Task A_drawing_that_is_another_file_now_is_said()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf", "POST", "Galil", "a.dmc");
        await File.AppendAllTextAsync(talk.PathOf("part.dxf"), "\n");
        await talk.TypeAsync("HISTORY", "Rerun", "1");

        Assert.Contains("part.dxf has changed since that job", talk.Said, StringComparison.Ordinal);
    }
}
