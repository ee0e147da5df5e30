using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.HandMoves;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.TestKit;

namespace Engraver.App.Tests.HandMoves;

/// <summary>The Machine page with mouse and keys: a press moves; a release stops, and so does the loss of focus, pointer or window. The clock of the test
/// advances while the operator waits.</summary>
[Collection(DesktopCollection.Name)]
public sealed class JogPadTests(DesktopFixture fixture)
{
    /// <summary>Of the simulated machine, by the clock of the test.</summary>
    private const int Speed = 8;

    [Fact]
    public Task A_press_moves_and_the_release_stops() => WithPad(here =>
    {
        Choose(here, "Continuous");
        here.Until(() => here.Commands.Machine.ReadyJogs.IsKeptReady);
        Assert.Equal("READY", here.Find<TextBlock>("StateText").Text);
        here.Hands.PressButton(Cell(here, "X+"));
        here.Until(() => X(here) > 1.0);
        Assert.Equal("MOVING", here.Find<TextBlock>("StateText").Text);
        here.Hands.ReleaseButton(Cell(here, "X+"));
        AssertStopped(here);

        Assert.InRange(X(here), 1.0, 100.0);
        Assert.Equal(0.0, Y(here));
        AssertReleasedInTime(here);
    });

    [Theory]
    [InlineData("leaves the window")]
    [InlineData("shows another palette")]
    [InlineData("presses stop")]
    [InlineData("closes")]
    public Task Whatever_takes_the_hand_away_stops_it(string what) => WithPad(here =>
    {
        Choose(here, "Continuous");
        here.Hands.PressButton(Cell(here, "Y+"));
        here.Until(() => Y(here) > 1.0);

        if (what == "leaves the window") here.Hands.LoseFocus();
        if (what == "shows another palette") here.Find<TextBox>("LineBox").Focus();
        if (what == "presses stop") here.Hands.Press(Key.Pause);
        if (what == "closes") here.Hands.RequestClose();
        AssertStopped(here);

        Assert.InRange(Y(here), 1.0, 100.0);
        AssertReleasedInTime(here);
    });

    /// <summary>Started by a command, not by the pad: the window sends the heartbeat, and the loss of the window ends the jog.</summary>
    [Theory]
    [InlineData("leaves the window", "The window lost the focus")]
    [InlineData("makes it small", "The window lost the focus")]
    [InlineData("asks to close", "The window lost the focus")]
    [InlineData("hangs", "did not respond in time")]
    public Task A_jog_without_an_end_that_a_command_began_stops_too(string what, string said)
    {
        var clock = new ManualTimeProvider();
        return WithPad(
            here =>
            {
                here.Enter("CNCJOG", "X+", "Continuous");
                here.Until(() => X(here) > 60.0); // several times as long as the machine waits for a heartbeat
                Assert.True(here.Commands.Machine.IsRunning);

                if (what == "leaves the window") here.Hands.LoseFocus();
                if (what == "makes it small") here.Window.WindowState = WindowState.Minimized;
                if (what == "asks to close") here.Hands.RequestClose();
                if (what == "hangs") clock.Advance(TimeSpan.FromSeconds(0.4)); // on the window's own thread, which is blocked meanwhile
                here.Until(() => !here.Commands.Machine.IsRunning);

                here.Until(() => here.History.Any(line => line.Contains(said, StringComparison.Ordinal)));
                if (what == "makes it small") here.Window.WindowState = WindowState.Normal;
                here.Hands.Press(Key.Escape);
            },
            clock);
    }

    /// <summary>Typed just before the window is left: the operator would not see the motion.</summary>
    [Fact]
    public Task A_jog_that_begins_in_a_window_that_was_left_gets_no_sign() => WithPad(here =>
    {
        here.Enter("CNCJOG", "X+");
        here.Hands.LoseFocus();
        var asked = here.Desk.Queue.EnterAsync("Continuous");
        here.Until(() => asked.IsCompleted);
        here.Until(() => here.History.Any(line => line.Contains("did not respond in time", StringComparison.Ordinal)) && !here.Commands.Machine.IsRunning);

        Assert.InRange(X(here), 0.0, 40.0);
        here.Hands.Press(Key.Escape);
    });

    [Fact]
    public Task Keys_jog_only_while_the_pad_has_the_focus_and_a_second_control_makes_them_fast() => WithPad(here =>
    {
        Choose(here, "Continuous");
        here.Hands.Press(Key.Right);
        here.Step();
        Assert.Equal(0.0, X(here));
        here.Find<JogPad>("Pad").Focus();
        here.Hands.KeyDown(Key.Left);
        here.Until(() => X(here) < -1.0);
        here.Hands.KeyDown(Key.Left); // keyboard repeat
        here.Hands.KeyUp(Key.Left);
        AssertStopped(here);
        Assert.InRange(X(here), -100.0, -1.0);
        Assert.Equal("", here.Find<TextBox>("LineBox").Text ?? "");
    });

    [Fact]
    public Task Without_a_machine_the_pad_looks_off_and_a_press_says_why() => fixture.WithOperator(here =>
    {
        here.Show("Machine");
        Assert.Contains("off", here.Find<JogPad>("Pad").Classes);
        here.Click(here.Find<JogPad>("Pad").GetVisualDescendants().OfType<Border>().First(cell => cell.Child is TextBlock { Text: "X+" }));
        Assert.Contains(here.History, line => line.Contains("No controller", StringComparison.Ordinal));
        Assert.All(here.Find<JogPad>("Pad").GetVisualDescendants().OfType<TextBlock>(), letter => Assert.Equal(0.4, letter.Opacity));

        here.Enter("CNCCONNECT", "sim:");
        Assert.DoesNotContain("off", here.Find<JogPad>("Pad").Classes);
    });

    [Fact]
    public Task While_a_job_stands_held_the_pad_moves_and_the_job_goes_on_at_its_place() => WithPad(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCARM", "Stream");
        here.Show("Machine");
        Choose(here, "Continuous");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status is { State: Workbench.Machines.MachineState.Running, ToolCommanded: true } && Y(here) > 49.0);
        Assert.Contains("off", here.Find<JogPad>("Pad").Classes);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Commands.Machine.Status.State == Workbench.Machines.MachineState.Held);
        here.Step();
        Assert.DoesNotContain("off", here.Find<JogPad>("Pad").Classes);
        var held = Y(here);
        here.Hands.PressButton(Cell(here, "Y+"));
        here.Until(() => Y(here) > held + 1.0);
        here.Hands.ReleaseButton(Cell(here, "Y+"));
        here.Until(() => Model(here).Jogged.IsCompleted);
        here.Click(here.Find<Button>("StartKey"));
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Equal("DONE", here.Find<TextBlock>("StateText").Text);
        AssertReleasedInTime(here);
    });

    /// <summary>Each press is a step, also a press before the previous step has ended; the job continues at its position.</summary>
    [Fact]
    public Task While_a_job_stands_held_the_pad_steps_and_the_job_goes_on_at_its_place() => WithPad(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCARM", "Stream");
        here.Show("Machine");
        Choose(here, "10");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status is { State: Workbench.Machines.MachineState.Running, ToolCommanded: true } && Y(here) > 49.0);
        here.Hands.Click(Cell(here, "Y+"));
        here.Step();
        Assert.Contains("A job or a move is running.", here.History);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Commands.Machine.Status.State == Workbench.Machines.MachineState.Held);
        here.Step();
        var (x, y) = (X(here), Y(here));
        here.Hands.Click(Cell(here, "Y+"));
        here.Hands.Click(Cell(here, "Y+"));
        here.Until(() => Math.Abs(Y(here) - y - 20.0) < 0.001);
        Choose(here, "0.1");
        here.Hands.Click(Cell(here, "X−"));
        here.Until(() => Math.Abs(X(here) - x + 0.1) < 0.001);
        here.Until(() => here.Window.Canvas.Machine!.Place.DistanceTo(here.Commands.Machine.Status.WorkPosition!.Value) < 0.001);
        here.Click(here.Find<Button>("StartKey"));
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Complete, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.InRange(here.Commands.Machine.Runs.LastRun!.Judgement.MaxDeviationMm!.Value, 0.0, 0.01);
    });

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public Task Shift_and_the_fast_key_jog_faster_than_the_jog_speed_could(bool byShift)
    {
        var clock = new ManualTimeProvider();
        return WithPad(
            here =>
            {
                Choose(here, "Continuous");
                here.Find<JogPad>("Pad").Focus();
                if (!byShift) here.Hands.PressButton(here.MiddleOf(here.Find<Button>("FastKey")));
                var pressed = clock.GetTimestamp();
                here.Hands.KeyDown(Key.Left, byShift ? RawInputModifiers.Shift : RawInputModifiers.None);
                here.Until(() => -X(here) > (clock.GetElapsedTime(pressed).TotalSeconds * Speed * here.Commands.Machine.Profile.JogMmPerMinute / 60.0) + 5.0);
                here.Hands.KeyUp(Key.Left);
                AssertStopped(here);
                AssertReleasedInTime(here);
                if (!byShift) here.Hands.ReleaseButton(here.MiddleOf(here.Find<Button>("FastKey")));
                here.Step();
                Assert.False(Model(here).IsFast);
            },
            clock);
    }

    [Theory]
    [InlineData("lets it go")]
    [InlineData("leaves the window")]
    [InlineData("lets it go elsewhere")]
    public Task The_fast_key_is_fast_only_as_long_as_it_is_held(string how) => WithPad(here =>
    {
        var key = here.MiddleOf(here.Find<Button>("FastKey"));
        here.Hands.PressButton(key);
        here.Step();
        Assert.True(Model(here).IsFast);
        if (how == "lets it go") here.Hands.ReleaseButton(key);
        if (how == "leaves the window") here.Hands.LoseFocus();
        if (how == "lets it go elsewhere") here.Hands.ReleaseButton(key + new Vector(0, 200));
        here.Step();

        Assert.False(Model(here).IsFast);
        if (how == "leaves the window") here.Hands.ReleaseButton(key);
    });

    [Fact]
    public Task A_machine_with_a_z_axis_has_its_height_its_zero_and_its_place_in_the_origins() => fixture.WithOperator(here =>
    {
        here.Show("Machine");
        Assert.False(here.Find<Button>("ZeroZKey").IsEffectivelyVisible);
        Assert.Equal("X and Y", here.Find<Button>("ZeroAllKey").Content);
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "3,4", "CNCJOG", "Z+", "11.5", "CNCZERO", "X");
        Assert.Equal("X, Y and Z", here.Find<Button>("ZeroAllKey").Content);
        here.Click(here.Find<Button>("ZeroZKey"));
        here.WaitUntilIdle();
        Assert.Equal(new OriginRow("G54", "3, –, 11.5", true), Model(here).Origins[0]);
        here.Enter("CNCZERO", "Y", "CNCJOG", "Z-", "2.25");
        here.Until(() => here.Commands.Machine.Status.WorkHeight == -2.25);
        here.Step();

        Assert.Equal("Height: work -2.250, machine 9.250 mm", here.Find<TextBlock>("HeightText").Text);
        Assert.Equal(new OriginRow("G54", "3, 4, 11.5", true), Model(here).Origins[0]);
    });

    [Fact]
    public Task A_step_is_a_command_of_the_size_that_is_chosen() => WithPad(here =>
    {
        Choose(here, "0.1");
        here.Hands.Click(Cell(here, "X−"));
        AssertStopped(here);
        Assert.Equal(-0.1, X(here), 6);
        Assert.Contains(here.History, line => line.Contains("CNCJOG", StringComparison.Ordinal));
        Choose(here, "10");
        here.Hands.Click(Cell(here, "Y+"));
        AssertStopped(here);
        Assert.Equal((-0.1, 10.0), (Math.Round(X(here), 6), Y(here)));
    });

    [Fact]
    public Task A_click_on_the_canvas_is_a_place_to_go_to() => WithPad(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCZERO", "All", "CNCGOTO", "Work");
        here.Hands.Click(here.MiddleOf(here.Window.Canvas) + new Vector(40, -20));
        AssertStopped(here);

        var clicked = here.History.Last(line => line.StartsWith("Specify point of the drawing", StringComparison.Ordinal)).Split(": ")[^1].Split(',').Select(text => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture)).ToArray();
        Assert.Equal(clicked[0], X(here), 0.001);
        Assert.Equal(clicked[1], Y(here), 0.001);
        Assert.NotEqual(0.0, X(here));
        here.Click(here.Find<Button>("GoOriginKey"));
        AssertStopped(here);
        Assert.Equal((0.0, 0.0), (X(here), Y(here)));
        here.Click(here.Find<Button>("GoClearanceKey"));
        here.WaitUntilIdle();
        Assert.Contains(here.History, line => line.Contains("no clearance height", StringComparison.Ordinal));
    });

    [Fact]
    public Task What_cannot_jog_says_why_and_moves_nothing() => fixture.WithOperator(here =>
    {
        here.Show("Machine");
        Choose(here, "Continuous");
        here.Hands.Click(Cell(here, "X+"));
        here.Step();
        Assert.Contains("No controller is connected. Connect one with CNCCONNECT.", here.History);
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCMOTORS", "OFF");
        here.Hands.Click(Cell(here, "X+"));
        here.Step();
        Assert.Contains(here.History, line => line.Contains("CNCMOTORS ON", StringComparison.Ordinal));
        Assert.Equal(0.0, X(here));
    });

    [Fact]
    public Task Origins_and_outputs_are_listed_chosen_and_switched_behind_their_guard() => WithPad(here =>
    {
        here.Enter("CNCGOTO", "3,4");
        here.Click(here.Find<Button>("ZeroAllKey"));
        here.WaitUntilIdle();
        var model = Model(here);
        Assert.Equal(new OriginRow("G54", "3, 4", true), model.Origins[0]);
        model.ChooseOrigin(model.Origins[1]);
        here.WaitUntilIdle();
        Assert.Equal(new OriginRow("G55", "not set", true), model.Origins[1]);

        model.SwitchOutput(model.Outputs[1]);
        here.WaitUntilIdle();
        Assert.Equal(false, model.Outputs[1].IsOn);
        Assert.DoesNotContain(here.History, line => line.Contains("CNCOUTPUT", StringComparison.Ordinal));
        here.Find<CheckBox>("GuardBox").BringIntoView();
        here.Step();
        here.Click(here.Find<CheckBox>("GuardBox"));
        Assert.True(model.IsGuardOpen);
        model.SwitchOutput(model.Outputs[1]);
        here.WaitUntilIdle();
        here.Enter("Yes");
        here.Until(() => model.Outputs[1].IsOn == true);
        model.SwitchOutput(model.Outputs[1]);
        here.WaitUntilIdle();
        here.Until(() => model.Outputs[1].IsOn == false);
    });

    private Task WithPad(Action<Operator> act, ManualTimeProvider? clock = null) => fixture.WithOperator(
        here =>
        {
            here.Enter("CNCCONNECT", FormattableString.Invariant($"sim:?speed={Speed}"));
            here.Show("Machine");
            act(here);
        },
        clock: clock ?? new ManualTimeProvider());

    private static HandMovesModel Model(Operator here) => (HandMovesModel)here.Find<JogPad>("Pad").DataContext!;

    private static void Choose(Operator here, string step) =>
        here.Click(here.Find<ItemsControl>("StepList").GetVisualDescendants().OfType<ToggleButton>().First(button => button.Content as string == step));

    private static Point Cell(Operator here, string sign) => here.MiddleOf(here.Find<JogPad>("Pad").GetVisualDescendants().OfType<Border>().First(cell => cell is { Tag: JogVelocity, Child: TextBlock text } && text.Text == sign));

    private static double X(Operator here) => here.Commands.Machine.Status.MachinePosition!.Value.X;

    private static double Y(Operator here) => here.Commands.Machine.Status.MachinePosition!.Value.Y;

    /// <summary>Asserts that the release ended the jog, not the heartbeat timeout of 0.3 s, which would be reported.</summary>
    private static void AssertReleasedInTime(Operator here) => Assert.DoesNotContain(Engraver.App.Texts.Text.Get("Pad.WindowTooSlow"), here.History);

    private static void AssertStopped(Operator here)
    {
        here.WaitUntilIdle();
        here.Until(() => Model(here).Jogged.IsCompleted && !here.Commands.Machine.IsRunning);
    }
}
