using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Stages;

public class JobStagesTests
{
    [Fact]
    public void Each_stage_takes_the_state_that_the_stage_before_returns()
    {
        var state = typeof(DrawnJob);
        foreach (var stage in JobStages.All)
        {
            Assert.True(stage.Input.IsAssignableFrom(state), $"{stage.Key} takes {stage.Input.Name}, the stage before returns {state.Name}");
            state = stage.Output;
        }

        Assert.Equal(typeof(PlannedJob), state);
    }

    [Fact]
    public void Each_stage_has_its_own_key_and_its_texts()
    {
        Assert.Equal(JobStages.All.Count, JobStages.All.Select(stage => stage.Key).Distinct().Count());
        Assert.All(JobStages.All, stage =>
        {
            Assert.Equal(stage.Key + "Stage", stage.GetType().Name);
            Assert.NotEmpty(stage.Work);
            Assert.NotEmpty(stage.Result);
            Assert.Equal(stage.StartsStep, Wording.Find($"Stage.{stage.Key}.Progress") is not null);
            Assert.All(stage.Settings, setting => Assert.Contains(setting, SettingTable.All));
        });
    }

    [Fact]
    public void The_progress_shows_five_steps_and_cancellation_is_checked_between_stages()
    {
        using var cancel = new CancellationTokenSource();
        var steps = new Steps();
        _ = new StageRun(Job(), cancel.Token, steps).To<PlannedJob>();
        Assert.Equal([("Table", 0.0), ("Chain", 0.1), ("Path", 0.5), ("Motion", 0.6), ("Program", 0.8)], steps.Seen);

        steps.Seen.Clear();
        steps.Reported = cancel.Cancel;
        Assert.Throws<OperationCanceledException>(() => new StageRun(Job(), cancel.Token, steps).To<PlannedJob>());
        Assert.Equal("Table", Assert.Single(steps.Seen).Key);
    }

    [Fact]
    public void A_run_continues_where_it_was()
    {
        var run = new StageRun(Job(), CancellationToken.None);
        var chained = run.To<ChainedJob>();
        var path = run.To<PathJob>();

        Assert.Same(chained.Cut, path.Cut);
        Assert.Same(path, run.To<OrderedJob>());
        Assert.Equal(JobPreparation.To<PathJob>(chained.Drawing, chained.Settings).Toolpath.Strokes.Count, path.Toolpath.Strokes.Count);
    }

    [Fact]
    public void A_run_that_is_given_a_later_state_starts_behind_its_stage()
    {
        var steps = new Steps();
        var chained = JobPreparation.To<ChainedJob>(Job().Drawing, Job().Settings);
        var run = new StageRun(chained, CancellationToken.None, steps);

        Assert.Same(chained, run.To<AnalysedJob>());
        Assert.Same(chained.Cut, run.To<PlannedJob>().Cut);
        Assert.Equal(["Path", "Motion", "Program"], steps.Seen.Select(step => step.Key));
    }

    /// <summary>Reading, execution and judgement are outside of the list; their rows of the table are written by hand.</summary>
    [Fact]
    public void The_page_lists_the_stages()
    {
        var page = Path.Combine(RepositoryFolder.Root, "docs", "pipeline.md");
        var lines = File.ReadAllLines(page);
        var (read, execute) = (Array.FindIndex(lines, line => line.StartsWith("| read |", StringComparison.Ordinal)), Array.FindIndex(lines, line => line.StartsWith("| execute |", StringComparison.Ordinal)));

        Assert.True(read >= 0 && execute > read, "docs/pipeline.md has no rows 'read' and 'execute'");
        GoldenFile.Check(page, string.Join('\n', [.. lines[..(read + 1)], .. JobStages.All.Select(Row), .. lines[execute..]]) + "\n");
    }

    private static string Row(JobStage stage) =>
        $"| {stage.Work} | `{stage.GetType().Name}` | `{stage.Input.Name}` | `{stage.Output.Name}`: {stage.Result} | {string.Join(", ", stage.Settings.Select(setting => $"`{setting.Key}`"))} |";

    private static DrawnJob Job() => new(new DrawingBuilder().Line(0, 0, 10, 0).Circle(20, 5, 3).Build(), new DrawingSettings());

    private sealed class Steps : IProgress<JobStage>
    {
        public List<(string Key, double Before)> Seen { get; } = [];

        public Action? Reported { get; set; }

        public void Report(JobStage value)
        {
            Seen.Add((value.Key, Math.Round(value.Before, 9)));
            Reported?.Invoke();
        }
    }
}
