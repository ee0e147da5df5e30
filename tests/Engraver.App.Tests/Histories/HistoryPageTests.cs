using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.Histories;
using Engraver.Workbench.Histories;

namespace Engraver.App.Tests.Histories;

[Collection(DesktopCollection.Name)]
public sealed class HistoryPageTests(DesktopFixture fixture)
{
    [Fact]
    public Task Jobs_are_listed_searched_and_opened_with_their_settings_again() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCMAXERR", "0.004", "CNCSIM");
        here.Open("paper-001.dxf");
        here.Enter("CNCMAXERR", "0.001", "CNCSIM");
        here.Show("History");
        here.Until(() => Rows(here).Count == 2);
        Assert.Equal([("paper-001.dxf", "complete", "simulation"), ("gasket.dxf", "complete", "simulation")], Rows(here).Select(row => (row.Drawing, row.Outcome, row.Kind)));

        here.Click(here.Find<TextBox>("HistorySearchBox"));
        here.Hands.Type("gasket");
        here.Until(() => Rows(here).Count == 1);
        var row = here.Window.GetVisualDescendants().OfType<ListBoxItem>().First(item => item.DataContext is HistoryRow);
        here.Click(row);
        here.Click(here.Find<Button>("HistoryRerunButton"));
        here.Until(() => !here.Desk.Queue.IsBusy && here.Commands.Document.Current.Settings.MaxErrorMm == 0.004);
        Assert.Equal("gasket.dxf", Path.GetFileName(here.Commands.Document.Current.Drawing!.FileName));
    });

    /// <summary>Steppers give no feedback: their deviation is that of the commanded path.</summary>
    [Fact]
    public void The_deviation_of_steppers_says_that_it_was_commanded()
    {
        var run = new HistoryEntry { Date = default, Kind = "run", Drawing = "/part.dxf", Target = "galil", Outcome = "complete", MaxDeviation = 0.1, Settings = new Dictionary<string, string>() };
        HistoryRow Row(HistoryEntry entry) => new(entry, TimeZoneInfo.Utc);

        Assert.Equal(("0.1000", "/part.dxf"), (Row(run).Deviation, Row(run).Tip));
        Assert.Equal(("0.1000 cmd", "commanded; lost steps are not detected (steppers: X, Y)\n/part.dxf"), (Row(run with { OpenLoop = ['X', 'Y'] }).Deviation, Row(run with { OpenLoop = ['X', 'Y'] }).Tip));
    }

    [Fact]
    public Task Twice_on_a_job_opens_its_drawing() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCSIM");
        here.Open("paper-001.dxf");
        here.Show("History");
        here.Until(() => Rows(here).Count == 1);
        var row = here.Window.GetVisualDescendants().OfType<ListBoxItem>().First(item => item.DataContext is HistoryRow);
        here.Click(row);
        here.Click(row);
        here.Until(() => !here.Desk.Queue.IsBusy && Path.GetFileName(here.Commands.Document.Current.Drawing!.FileName) == "gasket.dxf");
    });

    private static IReadOnlyList<HistoryRow> Rows(Operator here) => ((HistoryModel)here.Find<ListBox>("HistoryList").DataContext!).Rows;
}
