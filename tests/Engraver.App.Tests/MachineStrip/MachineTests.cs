using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.MachineStrip;
using Engraver.App.Tabs;
using Engraver.App.Terminals;
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
        here.WaitUntilIdle();
        Assert.Equal("ARMED", here.Find<TextBlock>("StateText").Text);
        here.Click(here.Find<Button>("StartKey"));
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Equal(1.0, here.Window.Model.Machine.Progress);
        Assert.Equal(here.Window.Canvas.Overlay!.MoveCount, here.Window.Canvas.EngravedMoves);
        Assert.Equal("DONE", here.Find<TextBlock>("StateText").Text);
    });

    /// <summary>The progress of one drawing is not shown for another one, nor under ARMED.</summary>
    [Fact]
    public Task Progress_ends_with_the_drawing_it_is_of_and_with_the_next_arming() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:", "CNCARM", "Stream", "CNCRUN");
        here.WaitUntilIdle();
        Assert.Equal(("DONE", 1.0), (here.Find<TextBlock>("StateText").Text, here.Window.Model.Machine.Progress));
        here.Enter("CNCARM", "Stream");
        here.WaitUntilIdle();
        Assert.Equal(("ARMED", 0.0, "", 0), (here.Find<TextBlock>("StateText").Text, here.Window.Model.Machine.Progress, here.Window.Model.Machine.SegmentsText, here.Window.Canvas.EngravedMoves));
        here.Enter("CNCRUN");
        here.WaitUntilIdle();
        Assert.True(here.Window.Canvas.EngravedMoves > 0);
        here.Open("gasket.dxf");
        here.WaitUntilIdle();

        Assert.Equal(("READY", 0.0, "", ""), (here.Find<TextBlock>("StateText").Text, here.Window.Model.Machine.Progress, here.Window.Model.Machine.SegmentsText, here.Window.Model.Machine.TimeLeft));
        Assert.Equal(0, here.Window.Canvas.EngravedMoves);
    });

    [Fact]
    public Task A_dry_run_is_a_state_of_its_own_armed_running_and_done() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Dryrun", "Stream");
        Assert.Contains("dry run", here.Find<TextBlock>("ReasonText").Text, StringComparison.Ordinal);
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.DryRun, Progress: not null }); // the job is on the machine and has reported its position
        here.Step();
        Assert.Equal(("DRY RUN", "ActLampBrush", "Shape.DryRun"), (here.Find<TextBlock>("StateText").Text, here.Window.Model.Machine.LampKey, here.Window.Model.Machine.ShapeKey));
        Assert.Contains("DRY RUN", here.Window.Title, StringComparison.Ordinal);
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        Assert.Equal("STOPPED", here.Find<TextBlock>("StateText").Text);
    });

    [Fact]
    public Task A_dry_run_leaves_nothing_that_looks_engraved() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", "sim:", "CNCARM", "Dryrun", "Stream", "CNCRUN");
        here.WaitUntilIdle();
        Assert.Equal("DONE", here.Find<TextBlock>("StateText").Text);
        Assert.Equal(0, here.Window.Canvas.EngravedMoves);
        Assert.Contains(here.History, line => line.Contains("segments traversed", StringComparison.Ordinal) && line.Contains("nothing was cut", StringComparison.Ordinal));
    });

    [Fact]
    public Task Enter_and_space_never_start_motion() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:", "CNCARM", "Stream");
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        Assert.Null(here.Commands.Machine.Runs.LastRun);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        here.Enter("CNCRUN");
        Assert.NotNull(here.Commands.Machine.Runs.LastRun);
        var first = here.Commands.Machine.Runs.LastRun;
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.Same(first, here.Commands.Machine.Runs.LastRun);
    });

    [Theory]
    [InlineData(Key.Pause, RawInputModifiers.None)]
    [InlineData(Key.Space, RawInputModifiers.Control)]
    public Task A_stop_key_stops_a_job(Key key, RawInputModifiers modifiers) => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        here.Hands.Press(key, modifiers);
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
    });

    [Fact]
    public Task Escape_holds_a_job_and_the_start_key_lets_it_go_on() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        Assert.Equal("START", here.Find<TextBlock>("StartText").Text);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Find<TextBlock>("StateText").Text == "HELD");
        Assert.False(here.Commands.Machine.Status.ToolCommanded);
        Assert.False(here.Find<Button>("HoldKey").IsEffectivelyEnabled);
        Assert.Equal("RESUME", here.Find<TextBlock>("StartText").Text);
        here.Hands.Press(Key.Escape); // on the second press the job is already held
        here.Step();
        Assert.Equal("HELD", here.Find<TextBlock>("StateText").Text);
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Find<TextBlock>("StateText").Text == "RUNNING");
        here.Click(here.Find<Button>("HoldKey"));
        here.Until(() => here.Find<TextBlock>("StateText").Text == "HELD");
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();

        Assert.Equal((JobOutcome.Stopped, 2), (here.Commands.Machine.Runs.LastRun!.Result.Outcome, here.Commands.Machine.Runs.LastRun.Result.Holds));
    });

    /// <summary>Two segments of which the second takes a hundred times as long: half of the segments is not half of the job, and within the long one the
    /// progress continues.</summary>
    [Fact]
    public Task Progress_is_that_of_the_planned_time() => fixture.WithOperator(here =>
    {
        here.Enter("NEW", "CNCFITARCS", "0", "LINE", "0,0", "1,0", "100,0", "", "CNCCONNECT", "sim:?speed=1", "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        var strip = here.Window.Model.Machine;
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.Running, Progress: { SegmentsDone: 1, ToolOn: true } } && strip.Progress > 0.0);
        Assert.InRange(strip.Progress, 0.0, 0.4);
        var (before, left) = (strip.Progress, strip.TimeLeft);
        here.Until(() => strip.Progress > before + 0.1 && strip.TimeLeft != left);
        Assert.Equal(1, here.Commands.Machine.Status.Progress!.SegmentsDone);
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
    });

    /// <summary>An ellipse is one entity but many moves of the machine.</summary>
    [Fact]
    public Task What_is_done_is_shown_behind_an_ellipse_too() => fixture.WithOperator(here =>
    {
        here.Enter("NEW", "CIRCLE", "0,0", "3", "ELLIPSE", "C", "20,0", "@12,0", "7", "CIRCLE", "60,0", "3");
        here.Enter("CNCCONNECT", "sim:", "CNCRESUME", "Contour", "3");
        var strokes = here.Commands.Derivation.Current.Job!.Toolpath.Strokes;

        Assert.Equal([1, 1], [strokes[0].Moves.Count, strokes[2].Moves.Count]);
        Assert.Equal(strokes[0].Moves.Count + strokes[1].Moves.Count, here.Window.Canvas.EngravedMoves);
    });

    [Fact]
    public Task What_will_not_be_cut_again_is_shown_as_done_before_it_is_armed() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", "sim:");
        Assert.Equal(0, here.Window.Canvas.EngravedMoves);
        here.Enter("CNCRESUME", "Contour", "2");
        Assert.InRange(here.Window.Canvas.EngravedMoves, 1, here.Window.Canvas.Overlay!.MoveCount - 1);
        here.Enter("CNCRESUME", "Whole");

        Assert.Equal(0, here.Window.Canvas.EngravedMoves);
    });

    [Fact]
    public Task The_feed_override_stands_in_the_strip_and_its_keys_change_it() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:");
        Assert.Equal("100 %", here.Find<TextBlock>("OverrideText").Text);
        here.Click(here.Find<Button>("SlowerKey"));
        here.Click(here.Find<Button>("SlowerKey"));
        here.Step();
        Assert.Equal("80 %", here.Find<TextBlock>("OverrideText").Text);
        here.Enter("CNCOVERRIDE", "Rapid", "50");
        Assert.Equal(("80 %", "R 50 %"), (here.Find<TextBlock>("OverrideText").Text, here.Find<TextBlock>("RapidsText").Text));
        here.Click(here.Find<Button>("FasterKey"));
        here.Click(here.Find<Button>("RapidsSlowerKey"));
        here.Click(here.Find<Button>("RapidsSlowerKey"));
        here.Click(here.Find<Button>("RapidsFasterKey"));
        here.Step();
        Assert.Equal((0.9, 0.4), RequestedRatios(here));
    });

    [Theory]
    [InlineData("none")]
    [InlineData("a job")]
    public Task Keys_change_feed_and_rapids_and_type_nothing(string runs) => fixture.WithOperator(here =>
    {
        if (runs == "a job") StartSlowly(here);
        else here.Enter("CNCCONNECT", "sim:");
        here.Hands.Press(Key.OemPlus, RawInputModifiers.Control);
        here.Hands.Press(Key.Add, RawInputModifiers.Control);
        here.Hands.Press(Key.OemMinus, RawInputModifiers.Control);
        here.Hands.Press(Key.OemComma, RawInputModifiers.Control);
        here.Hands.Press(Key.OemComma, RawInputModifiers.Control);
        here.Hands.Press(Key.OemComma, RawInputModifiers.Control);
        here.Hands.Press(Key.OemPeriod, RawInputModifiers.Control);
        here.Until(() => RequestedRatios(here) == (1.1, 0.8));
        Assert.Equal("", here.Window.Model.Command.Line);
        for (var presses = 0; presses < 20; presses++) here.Hands.Press(Key.OemPeriod, RawInputModifiers.Control);
        here.Step();
        Assert.Equal((1.1, 1.0), RequestedRatios(here)); // not above the rapids of the plan
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task The_strip_shows_the_height_of_a_machine_that_has_one() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        Assert.False(here.Find<TextBlock>("ZText").IsEffectivelyVisible);
        here.Enter("CNCDISCONNECT", "CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "Z+", "7.5");
        here.Enter("CNCZERO", "All", "CNCJOG", "Z-", "2.25");
        here.Until(() => here.Commands.Machine.Status.WorkHeight == -2.25);
        here.Step();

        Assert.True(here.Find<TextBlock>("ZText").IsEffectivelyVisible);
        Assert.Equal(("-2.250", "/ 5.250 mm"), (here.Find<TextBlock>("ZText").Text, here.Find<TextBlock>("MachineHeightText").Text));
    });

    [Fact]
    public Task Stop_acts_when_it_is_pressed_not_when_it_is_let_go() => fixture.WithOperator(here =>
    {
        StartSlowly(here);
        var stop = here.Find<Button>("StopKey");
        Assert.True(stop.Bounds.Width >= 64 && stop.Bounds.Height >= 64);
        here.Hands.PressButton(here.MiddleOf(stop));
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        here.Hands.ReleaseButton(here.MiddleOf(stop));
    });

    /// <summary>The user interface thread only waits here: the stop comes from the input thread.</summary>
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
        here.WaitUntilIdle();
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
    });

    /// <summary>The bytes themselves, observed on a TCP link while the thread of the window is blocked.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Stop_is_on_the_wire_while_the_window_is_busy(bool byMouse) => fixture.WithOperator(here =>
    {
        using var wire = new TcpMachine(here, speed: 2); // with its clock, so that the watchdog does not depend on the load of the computer
        StartSlowly(here, wire.Address);
        var place = here.MiddleOf(here.Find<Button>("StopKey"));
        using var braked = new ManualResetEventSlim();
        wire.CommandReceived += text =>
        {
            if (text.Contains("ST AB", StringComparison.Ordinal)) braked.Set();
        };
        var press = new Thread(() => Press(here, byMouse ? place : null));
        press.Start();

        Assert.True(braked.Wait(TimeSpan.FromSeconds(30)), "no ST AB came over the wire while the window was busy");
        press.Join();
        here.WaitUntilIdle();
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
    });

    [Fact]
    public Task A_job_runs_to_its_end_over_the_network() => fixture.WithOperator(here =>
    {
        using var wire = new TcpMachine(here, speed: double.PositiveInfinity);
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", wire.Address);
        Assert.False(here.Window.Model.Machine.IsSimulation);
        here.Click(here.Find<Button>("ArmKey"));
        here.WaitUntilIdle();
        here.Click(here.Find<Button>("StartKey"));
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Contains("DONE", here.Window.Title, StringComparison.Ordinal);
    });

    /// <summary>The recorded path stays until another drawing is shown; the origin is marked while it is known, and the travel to the finish is
    /// drawn.</summary>
    [Fact]
    public Task The_canvas_shows_where_the_machine_was_where_its_origin_lies_and_where_it_goes_at_the_end() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.WaitUntilIdle();
        Assert.Empty(here.Window.Canvas.Overlay!.OriginMarks);
        Assert.Equal(1, here.Window.Canvas.Overlay!.Finish.Count);
        here.Enter("CNCFINISH", "Stay");
        here.WaitUntilIdle();
        Assert.Equal(0, here.Window.Canvas.Overlay!.Finish.Count);
        here.Enter("CNCCONNECT", "sim:", "CNCGOTO", "5,5", "CNCZERO", "All");
        here.WaitUntilIdle();
        Assert.Equal(default, Assert.Single(here.Window.Canvas.Overlay!.OriginMarks).Place);

        here.Enter("CNCARM", "Stream", "CNCRUN");
        here.WaitUntilIdle();
        var recorded = here.Window.Canvas.Overlay!.Recorded;
        Assert.True(recorded.Count > 10);
        Assert.All(recorded.Primitives, line => Assert.Equal(0, (int)line.Colour)); // a perfect motor has no following error
        here.Enter("CNCTRACE", "Colour", "Speed");
        here.WaitUntilIdle();
        Assert.True(here.Window.Canvas.Overlay!.Recorded.Primitives.Select(line => line.Colour).Distinct().Count() > 3);
        here.Enter("CNCTRACE", "Off");
        here.WaitUntilIdle();
        Assert.Equal(0, here.Window.Canvas.Overlay!.Recorded.Count);
        here.Enter("CNCTRACE", "LAst");
        here.WaitUntilIdle();
        Assert.Equal(recorded.Count, here.Window.Canvas.Overlay!.Recorded.Count);
        here.Open("gasket.dxf");
        here.WaitUntilIdle();
        Assert.Equal(0, here.Window.Canvas.Overlay!.Recorded.Count);
    });

    /// <summary>By the simulator's counts: three times with START, and again after STOP in the middle of a cut.</summary>
    [Fact]
    public Task START_cuts_in_the_same_place_again_also_after_STOP() => fixture.WithOperator(here =>
    {
        using var wire = new TcpMachine(here, speed: 20);
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", wire.Address, "CNCGOTO", "12.5,-7.25", "CNCZERO", "All");
        here.WaitUntilIdle();

        var first = Cut();
        Assert.Equal(first, Cut());
        here.Click(here.Find<Button>("ArmKey"));
        here.WaitUntilIdle();
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status is { ToolCommanded: true, Progress.SegmentsDone: > 0 });
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        Assert.Equal("STOPPED", here.Find<TextBlock>("StateText").Text);

        Assert.Equal(first, Cut());
        Assert.Equal((12500, -7250), ((int)wire.Record[wire.Record.Count - 1].A, (int)wire.Record[wire.Record.Count - 1].B));

        (double, double, double, double) Cut()
        {
            var before = (int)wire.Record.Count;
            here.Click(here.Find<Button>("ArmKey"));
            here.WaitUntilIdle();
            here.Click(here.Find<Button>("StartKey"));
            here.WaitUntilIdle();
            Assert.Equal("DONE", here.Find<TextBlock>("StateText").Text);
            var rows = wire.Record.Snapshot().Skip(before).Where(row => row.Outputs != 0).ToList();
            return (rows.Min(row => (double)row.A), rows.Min(row => (double)row.B), rows.Max(row => (double)row.A), rows.Max(row => (double)row.B));
        }
    });

    [Fact]
    public Task A_command_that_the_controller_refuses_is_an_alarm() => fixture.WithOperator(here =>
    {
        using var wire = new TcpMachine(here, speed: 1);
        here.Enter("CNCCONNECT", wire.Address, "CNCMOTORS", "ON");
        var typed = here.Commands.Machine.Connection.Terminal.TypeAsync("JG 500;BGA", CancellationToken.None);
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
        Assert.Equal((1, false), (tab.PendingCount, tab.IsCreated));
        var told = here.Find<PageTabs>("Pages").GetVisualDescendants().OfType<ListBoxItem>().Single(item => item.DataContext == tab);
        Assert.Contains(told.GetVisualDescendants().OfType<TextBlock>(), text => text is { Text: "1", IsEffectivelyVisible: true });
        here.Show("Alarms");
        Assert.Equal(1, here.Find<ListBox>("AlarmList").ItemCount);
        Assert.All(here.Find<ListBox>("AlarmList").GetVisualDescendants().OfType<TextBlock>(), text => Assert.False(text.TextLayout.TextLines.Any(line => line.HasCollapsed || line.HasOverflowed), text.Text));
        here.Click(here.Find<Button>("AcknowledgeAllButton"));
        here.Step();
        Assert.DoesNotContain(here.Commands.Machine.Alarms.All, alarm => alarm.NeedsAcknowledging);
        here.WaitUntilIdle();
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
        var typed = here.Commands.Machine.Connection.Terminal.TypeAsync("SB 3", CancellationToken.None);
        here.Until(() => typed.IsCompleted && lamps.Bits == 4);
        Assert.Equal(0xFF, here.Find<BitLamps>("InputLamps").Bits); // no wires are connected: pulled up
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
        Assert.Null(here.Window.Model.Machine.Inputs); // the job does not query them
        Assert.False(here.Find<Button>("ArmKey").IsEffectivelyEnabled);
        Assert.False(here.Find<Button>("StartKey").IsEffectivelyEnabled);
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task The_terminal_talks_to_the_connected_controller() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Terminal");
        here.Click(here.Window.GetVisualDescendants().OfType<TerminalView>().Single().FindControl<TextBox>("LineBox")!);
        here.Hands.Type("MG 2+3");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Connection.Terminal.Lines.Count > 1);

        Assert.Contains(here.Commands.Machine.Connection.Terminal.Lines, line => line.Text.Contains("5.0000", StringComparison.Ordinal));
        Assert.Equal("", here.Window.Model.Command.Line);
    });

    private static (double Feed, double Rapid) RequestedRatios(Operator here) => (here.Commands.Machine.Status.FeedRatio, here.Commands.Machine.Status.RapidRatio);

    private static void Press(Operator here, Point? stop)
    {
        if (stop is { } place) here.Hands.PressButton(place);
        else here.Hands.Press(Key.Pause);
    }

    private static void StartSlowly(Operator here, string address = SlowSimulator.Address)
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running && here.Commands.Machine.Runs.Progress is { SegmentsSent: > 0 });
    }
}
