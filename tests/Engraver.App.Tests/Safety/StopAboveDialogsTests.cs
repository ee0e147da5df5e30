using Avalonia.Controls;
using Avalonia.Input;
using Engraver.Core.Machines;
using Engraver.SoftwarePlatform.Headless;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Safety;

/// <summary>STOP and the stop keys work whatever is in front of the window.</summary>
[Collection(DesktopCollection.Name)]
public sealed class StopAboveDialogsTests(DesktopFixture fixture)
{
    [Theory]
    [InlineData(null)]
    [InlineData(Key.Pause)]
    [InlineData(Key.Escape)]
    public Task A_modal_dialog_is_open(Key? key) => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        var entry = new TextBox();
        var dialog = new Window { Width = 300, Height = 200, Content = entry };
        var shown = dialog.ShowDialog(here.Window);
        here.Step();
        entry.Focus();
        var front = fixture.Desktop.Windows[^1];
        Assert.NotSame(here.Hands, front);
        Press(here, front, key);

        if (key == Key.Escape) here.Until(() => here.Commands.Machine.Status.State == MachineState.Held);
        if (key == Key.Escape) here.Commands.Machine.Controls.Stop();
        here.Until(() => here.Commands.Machine.Runs.LastRun is not null);
        Assert.Equal(key == Key.Escape ? 1 : 0, here.Commands.Machine.Runs.LastRun!.Result.Holds);
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.False(shown.IsCompleted);
        dialog.Close();
        here.WaitUntilIdle();
    });

    [Theory]
    [InlineData(null)]
    [InlineData(Key.Pause)]
    [InlineData(Key.Escape)]
    public Task The_connect_sheet_is_open(Key? key) => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Window.Model.Connect.Open();
        here.Step();
        Press(here, here.Hands, key);

        if (key == Key.Escape) here.Until(() => here.Commands.Machine.Status.State == MachineState.Held);
        if (key == Key.Escape) here.Commands.Machine.Controls.Stop();
        here.Until(() => here.Commands.Machine.Runs.LastRun is not null);
        Assert.Equal(key == Key.Escape ? 1 : 0, here.Commands.Machine.Runs.LastRun!.Result.Holds);
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.True(here.Window.Model.Connect.IsOpen);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task Escape_leaves_a_dialog_while_nothing_moves() => fixture.WithOperator(here =>
    {
        var dialog = new Window { Width = 300, Height = 200, Content = new TextBox() };
        var shown = dialog.ShowDialog(here.Window);
        here.Step();
        fixture.Desktop.Windows[^1].Press(Key.Escape);
        here.Until(() => shown.IsCompleted);

        Assert.True(here.Window.IsVisible);
    });

    [Fact]
    public Task A_menu_covers_the_window() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Click(here.Find<MenuItem>("MachineMenu"));
        Press(here, here.Hands, null);

        here.Until(() => here.Commands.Machine.Runs.LastRun is not null);
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task While_a_job_runs_the_first_wish_to_close_is_answered_with_a_warning_and_the_second_stops_the_machine() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Window.Close();
        here.Step();

        Assert.True(here.Window.IsVisible);
        Assert.True(here.Commands.Machine.IsRunning);
        Assert.Contains("Close the window again", here.History.Last(), StringComparison.Ordinal);

        here.Hands.Press(Key.Pause);
        here.Until(() => !here.Desk.IsMoving && !here.Commands.Machine.IsRunning);
        here.WaitUntilIdle();
        here.Window.Model.Command.Line = "";
        StartAgain(here);
        here.Window.Close();
        here.Step();
        Assert.True(here.Window.IsVisible); // another job, another warning

        here.Window.Close();
        here.Step();
        Assert.False(here.Window.IsVisible);
    });

    /// <param name="key">Null: the on-screen STOP of the main window.</param>
    private static void Press(Operator here, HeadlessWindow front, Key? key)
    {
        if (key is { } pressed) front.Press(pressed);
        else here.Hands.Click(here.MiddleOf(here.Find<Button>("StopKey")));
    }

    private static void StartSlowly(Operator here)
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address);
        StartAgain(here);
    }

    private static void StartAgain(Operator here)
    {
        here.Enter("CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine is { Status.State: MachineState.Running, Runs.Progress.SegmentsSent: > 0 });
    }
}
