using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Jobs;
using Engraver.App.Texts;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Jobs;

[Collection(DesktopCollection.Name)]
public sealed class JobTests(DesktopFixture fixture)
{
    [Fact]
    public Task What_is_not_so_is_marked_by_its_shape_and_its_colour() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Show("Job");

        Assert.Contains(("✓", false, "The drawing has no errors.", false), Lines(here));
        Assert.Contains(("✗", true, "No controller is connected; connect one with CNCCONNECT.", false), Lines(here));
    });

    [Fact]
    public Task What_the_job_costs_by_the_rates_of_the_profile_stands_in_its_palette() => fixture.WithOperator(here =>
    {
        var job = new JobModel(here.Desk);
        here.Open("paper-001.dxf");
        here.WaitUntilIdle();
        Assert.DoesNotContain(job.Figures, figure => figure.Name == Text.Get("Job.Cost"));

        here.Enter("CNCPROFILE", "machine-eroder.json");
        here.WaitUntilIdle();
        var cost = Assert.Single(job.Figures, figure => figure.Name == Text.Get("Job.Cost")).Value;
        Assert.EndsWith(", length 5.48, starts 3.50)", cost, StringComparison.Ordinal);
    });

    /// <summary>After a stop the machine is not at the start of the next job: this does not prevent the start, but it is shown as a warning.</summary>
    [Fact]
    public Task A_warning_is_told_from_what_has_passed_by_word_shape_and_colour() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Show("Job");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status.Progress is { Position.X: > 1.0 });
        here.Step();
        Assert.DoesNotContain(Lines(here), line => line.Mark == "▲"); // a running job is away from its start as expected
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        var warning = Assert.Single(Lines(here), line => line.Mark == "▲");
        Assert.StartsWith("WARNING: The last job on this machine ended early", warning.Sentence, StringComparison.Ordinal);
        Assert.True(warning.MarkIsColoured && warning.SentenceIsColoured);
        Assert.All(Lines(here).Where(line => line.Mark == "✓"), line => Assert.False(line.MarkIsColoured || line.SentenceIsColoured));
    });

    [Fact]
    public Task The_planned_time_is_of_the_line_that_the_controller_is_connected_by() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Show("Job");
        var network = here.Desk.Derived.PlannedSeconds;
        Assert.Equal(ClockText.Format(network), PlannedTime());
        var folder = Directory.CreateTempSubdirectory("serial-");
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var serving = controller.ServeSerialAsync(Path.Combine(folder.FullName, "tty"), 115200, CancellationToken.None);
        here.Until(() => serving.IsCompleted);
        here.Enter("CNCCONNECT", FormattableString.Invariant($"serial://{Path.Combine(folder.FullName, "tty")}?baud=115200"));
        here.WaitUntilIdle();

        Assert.True(here.Desk.Derived.PlannedSeconds > network + 1.0);
        Assert.Equal(ClockText.Format(here.Desk.Derived.PlannedSeconds), PlannedTime());
        Assert.Equal(here.Desk.Derived.PlannedSeconds, here.Desk.Derived.SecondsLeft(new EngravedProgress(0, 0, 70, default, false, 0.0)), 3.0);
        here.Enter("CNCDISCONNECT");
        Assert.Equal(ClockText.Format(network), PlannedTime());
        var ending = controller.DisposeAsync().AsTask();
        here.Until(() => ending.IsCompleted);
        folder.Delete(recursive: true);

        string PlannedTime() => ((JobModel)here.Find<ItemsControl>("CheckList").DataContext!).Figures.Single(figure => figure.Name == "Planned time").Value;
    });

    /// <summary>The list as shown on the page.</summary>
    private static List<(string Mark, bool MarkIsColoured, string Sentence, bool SentenceIsColoured)> Lines(Operator here) =>
    [
        .. from row in here.Find<ItemsControl>("CheckList").GetVisualDescendants().OfType<Grid>()
           let texts = row.Children.OfType<TextBlock>().ToArray()
           select (texts[0].Text!, texts[0].Classes.Contains("warning"), texts[1].Text!, texts[1].Classes.Contains("warning")),
    ];
}
