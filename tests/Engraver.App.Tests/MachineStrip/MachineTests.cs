using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.MachineStrip;
using Engraver.App.Tabs;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.App.Tests.MachineStrip;

[Collection(DesktopCollection.Name)]
public sealed class MachineTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_simulated_machine_frames_the_whole_window() => fixture.WithOperator(here =>
    {
        Assert.Equal("OFFLINE", here.Find<TextBlock>("StateText").Text);
        Assert.False(here.Find<TextBlock>("SimulationWord").IsEffectivelyVisible);
        here.Enter("CNCCONNECT", "sim:");

        Assert.Equal("READY", here.Find<TextBlock>("StateText").Text);
        Assert.True(here.Find<TextBlock>("SimulationWord").IsEffectivelyVisible);
        var frame = here.Find<Border>("Frame");
        Assert.Equal(new Thickness(4), frame.BorderThickness);
        Assert.Same(here.Window.FindResource(here.Window.ActualThemeVariant, "SimulationBrush"), frame.BorderBrush);
    });

    [Fact]
    public Task The_job_is_armed_and_started_with_the_keys_of_the_strip() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:");
        Assert.False(here.Find<Button>("StartKey").IsEffectivelyEnabled);
        here.Click(here.Find<Button>("ArmKey"));
        here.Rest();
        Assert.Equal("ARMED", here.Find<TextBlock>("StateText").Text);
        here.Click(here.Find<Button>("StartKey"));
        here.Rest();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.LastRun!.Result.Outcome);
        Assert.Equal(1.0, here.Window.Model.Machine.Progress);
        Assert.Equal(here.Window.Canvas.Overlay!.MoveCount, here.Window.Canvas.EngravedMoves);
        Assert.Equal("READY", here.Find<TextBlock>("StateText").Text);
    });

    [Fact]
    public Task Enter_and_space_never_start_motion() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:", "CNCARM", "Stream");
        here.Hands.Press(Key.Enter);
        here.Rest();
        Assert.Null(here.Commands.Machine.LastRun);
        here.Hands.Press(Key.Escape);
        here.Rest();
        here.Enter("CNCRUN");
        Assert.NotNull(here.Commands.Machine.LastRun);
        var first = here.Commands.Machine.LastRun;
        here.Hands.Press(Key.Enter);
        here.Rest();

        Assert.Same(first, here.Commands.Machine.LastRun);
    });

    [Theory]
    [InlineData(Key.Pause, RawInputModifiers.None)]
    [InlineData(Key.Space, RawInputModifiers.Control)]
    [InlineData(Key.Escape, RawInputModifiers.None)]
    public Task A_stop_key_stops_a_job(Key key, RawInputModifiers modifiers) => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Hands.Press(key, modifiers);
        here.Rest();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.LastRun!.Result.Outcome);
    });

    [Fact]
    public Task The_tool_stays_where_the_machine_stopped_until_the_playback_is_moved() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Until(() => here.Window.Model.Machine.Feed is not "–" and not "0");
        here.Hands.Press(Key.Pause);
        here.Rest();

        var place = here.Commands.Machine.Status.WorkPosition!.Value;
        var tool = here.Window.Canvas.ToolPosition!.Value;
        Assert.True(place.DistanceTo(default) > 0.1);
        Assert.Equal(place.X, tool.X * 25.4, 6); // the gasket is drawn in inches
        Assert.Equal(place.Y, tool.Y * 25.4, 6);
        Assert.Null(here.Window.Canvas.Highlight);
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 2;
        here.Step();
        Assert.Equal(here.Desk.Derived.Moment!.Value.Position.X, here.Window.Canvas.ToolPosition!.Value.X * 25.4, 6);
        Assert.NotNull(here.Window.Canvas.Highlight);
    });

    [Fact]
    public Task Stop_acts_when_it_is_pressed_not_when_it_is_let_go() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        var stop = here.Find<Button>("StopKey");
        Assert.True(stop.Bounds.Width >= 64 && stop.Bounds.Height >= 64);
        here.Hands.PressButton(here.MiddleOf(stop));
        here.Rest();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.LastRun!.Result.Outcome);
        here.Hands.ReleaseButton(here.MiddleOf(stop));
    });

    /// <summary>The user interface thread does nothing here but wait: the stop comes over the input thread.</summary>
    [Fact]
    public Task Stop_does_not_wait_for_a_busy_window() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        var place = here.MiddleOf(here.Find<Button>("StopKey"));
        using var stopped = new ManualResetEventSlim();
        here.Commands.Machine.Changed += (_, _) =>
        {
            if (!here.Commands.Machine.IsRunning) stopped.Set();
        };
        var press = new Thread(() => here.Hands.PressButton(place));
        press.Start();

        Assert.True(stopped.Wait(TimeSpan.FromSeconds(30)), "the job went on while the window was busy");
        press.Join();
        here.Rest();
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.LastRun!.Result.Outcome);
    });

    /// <summary>The bytes themselves: heard on a TCP wire while the thread of the window waits for them and does nothing else.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Stop_is_on_the_wire_while_the_window_is_busy(bool byMouse) => fixture.WithOperator(here =>
    {
        using var wire = new ServedMachine(here, speed: 1);
        StartSlowly(here, wire.Address);
        var place = here.MiddleOf(here.Find<Button>("StopKey"));
        using var braked = new ManualResetEventSlim();
        wire.Heard += text =>
        {
            if (text.Contains("ST AB", StringComparison.Ordinal)) braked.Set();
        };
        var press = new Thread(() => Press(here, byMouse ? place : null));
        press.Start();

        Assert.True(braked.Wait(TimeSpan.FromSeconds(30)), "no ST AB came over the wire while the window was busy");
        press.Join();
        here.Rest();
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.LastRun!.Result.Outcome);
    });

    [Fact]
    public Task A_job_runs_to_its_end_over_the_network() => fixture.WithOperator(here =>
    {
        using var wire = new ServedMachine(here, speed: double.PositiveInfinity);
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", wire.Address);
        Assert.False(here.Window.Model.Machine.IsSimulation);
        here.Click(here.Find<Button>("ArmKey"));
        here.Rest();
        here.Click(here.Find<Button>("StartKey"));
        here.Rest();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.LastRun!.Result.Outcome);
        Assert.Contains("READY", here.Window.Title, StringComparison.Ordinal);
    });

    [Fact]
    public Task A_command_that_the_controller_refuses_is_an_alarm() => fixture.WithOperator(here =>
    {
        using var wire = new ServedMachine(here, speed: 1);
        here.Enter("CNCCONNECT", wire.Address, "CNCMOTORS", "ON");
        var typed = here.Commands.Machine.Terminal.TypeAsync("JG 500;BGA", CancellationToken.None);
        here.Until(() => typed.IsCompleted);
        here.Enter("CNCMOTORS", "OFF"); // not while an axis moves
        here.Until(() => here.Commands.Machine.Alarms.Open.Count > 0);
        here.Show("Alarms");

        Assert.Contains(here.Commands.Machine.Alarms.Open, alarm => alarm.Cause == AlarmCause.Refused);
        Assert.Equal(1, here.Find<ListBox>("AlarmList").ItemCount);
    });

    [Fact]
    public Task A_lost_link_is_an_alarm_that_stays_until_it_is_seen() => fixture.WithOperator(here =>
    {
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var listening = controller.ListenTcpAsync(0, CancellationToken.None);
        here.Until(() => listening.IsCompleted);
        here.Enter("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{listening.Result.Port}"));
        Assert.False(here.Window.Model.Machine.IsSimulation);
        var ending = controller.DisposeAsync().AsTask();
        here.Until(() => here.Commands.Machine.Alarms.Open.Count > 0 && ending.IsCompleted);
        here.Step();

        Assert.Equal("FAULT", here.Find<TextBlock>("StateText").Text);
        Assert.Equal(("–", "–", null), (here.Window.Model.Machine.Tool, here.Window.Model.Machine.Feed, here.Window.Model.Machine.Outputs));
        var tab = here.Find<PageTabs>("Pages").Pages.Single(page => page.Key == "Alarms");
        Assert.Equal((1, false), (tab.Waiting, tab.IsMade));
        var told = here.Find<PageTabs>("Pages").GetVisualDescendants().OfType<ListBoxItem>().Single(item => item.DataContext == tab);
        Assert.Contains(told.GetVisualDescendants().OfType<TextBlock>(), text => text is { Text: "1", IsEffectivelyVisible: true });
        here.Show("Alarms");
        Assert.Equal(1, here.Find<ListBox>("AlarmList").ItemCount);
        Assert.All(here.Find<ListBox>("AlarmList").GetVisualDescendants().OfType<TextBlock>(), text => Assert.False(text.TextLayout.TextLines.Any(line => line.HasCollapsed || line.HasOverflowed), text.Text));
        here.Click(here.Find<Button>("AcknowledgeAllButton"));
        here.Step();
        Assert.DoesNotContain(here.Commands.Machine.Alarms.All, alarm => alarm.NeedsAcknowledging);
        here.Rest();
        Assert.DoesNotContain(told.GetVisualDescendants().OfType<TextBlock>(), text => text is { Text: "1", IsEffectivelyVisible: true });
        Assert.NotEqual(MachineState.Ready, here.Commands.Machine.Status.State);
        Assert.False(here.Find<Button>("ArmKey").IsEffectivelyEnabled);
    });

    [Fact]
    public Task Outputs_are_shown_where_there_is_room() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1280, 800));
        var lamps = here.Find<BitLamps>("OutputLamps");
        Assert.Null(lamps.Bits);
        here.Enter("CNCCONNECT", "sim:");
        var typed = here.Commands.Machine.Terminal.TypeAsync("SB 3", CancellationToken.None);
        here.Until(() => typed.IsCompleted && lamps.Bits == 4);
        Assert.Equal(0xFF, here.Find<BitLamps>("InputLamps").Bits); // nothing is wired to them: pulled up
        Assert.True(lamps.IsEffectivelyVisible);
        here.Hands.Resize(new Size(1024, 700));
        here.Step();

        Assert.False(lamps.IsEffectivelyVisible);
        Assert.True(here.Find<ProgressBar>("ProgressLine").Bounds.Width >= 40);
    });

    [Fact]
    public Task Outputs_are_known_while_a_job_runs() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Until(() => here.Window.Model.Machine is { Outputs: { } outputs, Tool: not "–" } && outputs != 0);

        Assert.Equal(MachineState.Running, here.Commands.Machine.Status.State);
        Assert.Null(here.Window.Model.Machine.Inputs); // the job does not ask for them
        Assert.False(here.Find<Button>("ArmKey").IsEffectivelyEnabled);
        Assert.False(here.Find<Button>("StartKey").IsEffectivelyEnabled);
        here.Hands.Press(Key.Pause);
        here.Rest();
    });

    [Fact]
    public Task The_terminal_talks_to_the_connected_controller() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Terminal");
        here.Click(here.Find<TextBox>("LineBox"));
        here.Hands.Type("MG 2+3");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Terminal.Lines.Count > 1);

        Assert.Contains(here.Commands.Machine.Terminal.Lines, line => line.Text.Contains("5.0000", StringComparison.Ordinal));
        Assert.Equal("", here.Window.Model.Command.Line);
    });

    private static void Press(Operator here, Point? stop)
    {
        if (stop is { } place) here.Hands.PressButton(place);
        else here.Hands.Press(Key.Pause);
    }

    private static void StartSlowly(Operator here, string address = SlowMachine.Address)
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running && here.Commands.Machine.Progress is { SegmentsSent: > 0 });
    }
}
