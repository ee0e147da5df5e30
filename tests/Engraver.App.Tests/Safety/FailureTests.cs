using Avalonia.Controls;
using Avalonia.Threading;
using Engraver.App.Safety;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Reports;

namespace Engraver.App.Tests.Safety;

[Collection(DesktopCollection.Name)]
public sealed class FailureTests(DesktopFixture fixture)
{
    [Fact]
    public Task What_fails_in_the_window_stops_the_job_and_leaves_the_window_alive() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        Dispatcher.UIThread.Post(() => throw new InvalidOperationException("A page lost its mind."));
        here.Step();
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        IsReported(here, "A page lost its mind");
        here.Enter("GRID", "OFF");
        Assert.False(here.Commands.View.Current.Grid);
    });

    [Fact]
    public Task What_fails_in_a_click_is_reported() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Find<Button>("ForwardButton").Click += (_, _) => throw new ArgumentException("The key is broken.");
        here.Click(here.Find<Button>("ForwardButton"));

        IsReported(here, "The key is broken");
    });

    [Fact]
    public Task What_fails_in_a_command_is_reported_and_the_next_one_runs() => fixture.WithOperator(here =>
    {
        here.Enter("FILEDIA", "0");
        here.Commands.Document.Changed += Fail;
        here.Hands.Type("OPEN gasket.dxf");
        here.Hands.Press(Avalonia.Input.Key.Enter);
        here.Until(() => here.Commands.Machine.Alarms.Open.Count > 0);
        here.Commands.Document.Changed -= Fail;
        IsReported(here, "Nobody expected this");
        here.Hands.Press(Avalonia.Input.Key.Escape);
        here.WaitUntilIdle();

        here.Open("paper-001.dxf");
        Assert.Contains("paper-001", here.Commands.Document.Current.Drawing!.FileName, StringComparison.Ordinal);

        static void Fail(object? sender, EventArgs e) => throw new NotImplementedException("Nobody expected this.");
    });

    [Fact]
    public void The_machine_is_stopped_before_anything_else()
    {
        var order = new List<string>();
        var alarms = new AlarmLog(TimeProvider.System);
        alarms.Changed += (_, _) => order.Add("alarm");
        var folder = Directory.CreateTempSubdirectory("failures-");
        var guard = new FailureGuard(() => order.Add($"stop, {folder.GetFiles().Length} reports"), alarms, new FailureReports(folder.FullName, new ManualTimeProvider()));
        for (var i = 0; i < 30; i++) guard.Handle(new InvalidOperationException("Again."));

        Assert.Equal(["stop, 0 reports", "alarm", "stop, 1 reports"], order.Take(3));
        Assert.Equal(30, Assert.Single(alarms.All).Count);
        Assert.Equal(20, folder.GetFiles().Length);
        folder.Delete(recursive: true);
    }

    [Fact]
    public void A_report_that_cannot_be_written_is_an_alarm_all_the_same()
    {
        var file = Path.GetTempFileName();
        var alarms = new AlarmLog(TimeProvider.System);
        var guard = new FailureGuard(() => { }, alarms, new FailureReports(file, TimeProvider.System));

        Assert.Null(guard.Handle(new InvalidOperationException("Broken.")));
        Assert.Equal(AlarmCause.InternalError, Assert.Single(alarms.All).Cause);
        File.Delete(file);
    }

    private static void IsReported(Operator here, string what)
    {
        var alarm = here.Commands.Machine.Alarms.Open.Single(alarm => alarm.Cause == AlarmCause.InternalError);
        Assert.Contains(what, alarm.What, StringComparison.Ordinal);
        var report = Assert.Single(Directory.GetFiles(here.Session.FailureReports.Folder, "crash-*.txt"));
        Assert.Contains(report, alarm.ToDo, StringComparison.Ordinal);
        Assert.Contains(what, File.ReadAllText(report), StringComparison.Ordinal);
    }

    private static void StartSlowly(Operator here)
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Avalonia.Input.Key.Enter);
        here.Until(() => here.Commands.Machine.Runs.Progress is { SegmentsSent: > 0 });
    }
}
