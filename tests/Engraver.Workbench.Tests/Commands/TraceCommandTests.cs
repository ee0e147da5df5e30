using Engraver.Core.Plots;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCTRACE: a saved run over its drawing.</summary>
public class TraceCommandTests
{
    [Fact]
    public async Task The_last_run_of_a_drawing_is_shown_over_it_and_taken_away()
    {
        await using var talk = await AfterTwoRunsAsync();
        var last = talk.Session.Machine.Runs.Recorded!;
        await talk.TypeAsync("CNCTRACE", "Off");
        Assert.Null(talk.Session.Machine.Runs.Recorded);
        await talk.TypeAsync("SHOW", "RECorded", "OFF");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCTRACE", "LAst"));

        var shown = talk.Session.Machine.Runs.Recorded!;
        Assert.Equal(last.Trace.Places.Count, shown.Trace.Places.Count);
        Assert.Same(talk.State.Drawing, shown.Job.Drawing);
        Assert.True(talk.Session.View.Current.Shown.HasFlag(CanvasLayers.Recorded));
        Assert.Contains("following error, maximum 0 mm (record, ", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task All_runs_are_listed_and_one_is_opened_by_its_journal_or_its_trace()
    {
        await using var talk = await AfterTwoRunsAsync();
        await talk.TypeAsync("CNCTRACE", "LIst");
        var files = talk.Said.Split('\n').Where(line => line.EndsWith(".trace.csv", StringComparison.Ordinal)).ToList();
        Assert.Equal(2, files.Count);
        Assert.Equal(files.Order(StringComparer.Ordinal), files);

        foreach (var file in new[] { files[0], files[0][..^".trace.csv".Length] })
        {
            await talk.TypeAsync("CNCTRACE", "Off");
            Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCTRACE", "File", file));
            Assert.NotNull(talk.Session.Machine.Runs.Recorded);
        }
    }

    [Fact]
    public async Task A_run_of_another_drawing_is_refused_and_what_was_shown_stays()
    {
        await using var talk = await AfterTwoRunsAsync();
        await talk.TypeAsync("CNCTRACE", "LIst");
        var file = talk.Said.Split('\n').Last(line => line.EndsWith(".trace.csv", StringComparison.Ordinal));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        var before = talk.Session.Machine.Runs.Recorded;

        Assert.Contains("does not match gasket.dxf: it cut another drawing or other layers", Failure(await talk.TypeAsync("CNCTRACE", "File", file)), StringComparison.Ordinal);
        Assert.Contains("No run of gasket.dxf is stored", Failure(await talk.TypeAsync("CNCTRACE", "LAst")), StringComparison.Ordinal);
        Assert.Contains("cannot be read", Failure(await talk.TypeAsync("CNCTRACE", "File", "nowhere.jsonl")), StringComparison.Ordinal);
        await File.WriteAllTextAsync(talk.PathOf("odd.trace.csv"), "# record; version 9; drawing x\n");
        Assert.Contains("its version is 9", Failure(await talk.TypeAsync("CNCTRACE", "File", "odd.trace.csv")), StringComparison.Ordinal);
        Assert.Same(before, talk.Session.Machine.Runs.Recorded);
    }

    [Fact]
    public async Task The_colour_is_a_variable_and_a_trace_without_the_following_error_says_so()
    {
        await using var talk = await AfterTwoRunsAsync();
        Assert.Equal(RunMeasure.Following, talk.Session.Settings.Current.TraceColour());
        await talk.TypeAsync("CNCTRACE", "Colour", "Speed");
        Assert.Equal(RunMeasure.Speed, talk.Session.Settings.Current.TraceColour());
        await talk.TypeAsync("CNCTRACECOLOR", "0");
        Assert.Equal(RunMeasure.Deviation, talk.Session.Settings.Current.TraceColour());

        await File.WriteAllTextAsync(talk.PathOf("old.trace.csv"), "# polled\nseconds,x,y,tool,deviation\n0,0,0,1,0\n1,5,0,1,0.5\n");
        await talk.TypeAsync("CNCTRACE", "File", "old.trace.csv");
        Assert.Contains("deviation from the drawing, maximum 0.5 mm (polled, 2 positions)", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("No following error was recorded", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCTRACE", "Colour", "Following");
        Assert.Contains("No following error was recorded", talk.Said, StringComparison.Ordinal);
    }

    private static string Failure(InputResult result) => Assert.IsType<InputResult.Failed>(result).Message;

    private static async Task<CommandTestSession> AfterTwoRunsAsync()
    {
        var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        for (var i = 0; i < 2; i++) Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM"));
        return talk;
    }
}
