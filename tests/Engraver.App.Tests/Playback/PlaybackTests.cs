using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Playback;

[Collection(DesktopCollection.Name)]
public sealed class PlaybackTests(DesktopFixture fixture)
{
    [Fact]
    public Task Row_contour_line_and_tool_move_together() => fixture.WithOperator(here =>
    {
        Prepare(here);
        Assert.Null(here.Window.Canvas.PlaybackPosition); // the playback is not in use
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total * 0.6;
        here.Step();

        var moment = here.Desk.Derived.Moment!.Value;
        Assert.Equal(moment.Row, here.Find<ListBox>("RowList").SelectedIndex);
        Assert.Equal(moment.Stroke, here.Find<ListBox>("ContourList").SelectedIndex);
        Assert.True(moment.Row > 0 && moment.Stroke > 0);
        Assert.Equal(moment.Entity, here.Window.Canvas.Highlight);
        Assert.Equal(moment.Position.X, here.Window.Canvas.PlaybackPosition!.Value.X * 25.4, 6);
        here.Show("Program");
        Assert.Equal(here.Commands.Playback.Motion!.LineOf(moment.Segment) - 1, here.Find<ListBox>("LineList").SelectedIndex);
    });

    [Fact]
    public Task While_a_job_runs_the_playback_stands_where_the_machine_is() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5");
        here.Show("Table");
        here.Click(here.Find<Button>("ArmKey"));
        here.WaitUntilIdle();
        here.Window.Model.Playback.PlayOrPause.Execute(null);
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.IsRunning && here.Desk.Derived.RowUnderTool > 1);

        Assert.False(here.Window.Model.Playback.IsPlaying);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.Held, Progress.ToolOn: false });
        here.Step();
        var (motion, told) = (here.Desk.Derived.Current.Motion!, here.Commands.Machine.Status.Progress!);
        Assert.InRange(here.Window.Model.Playback.At, motion.TimeOfSegment(told.SegmentsDone), motion.TimeOfSegment(told.SegmentsDone + 1));
        Assert.InRange(here.Desk.Derived.Moment!.Value.Position.DistanceTo(told.Position), 0.0, 3.0); // the last position reported with the tool on; at five times the speed the machine moved some millimetres further
        here.Click(here.Find<Button>("StartKey"));
        Assert.Equal(here.Desk.Derived.RowUnderTool, here.Find<ListBox>("RowList").SelectedIndex);
        Assert.Equal(here.Window.Model.Playback.At, here.Find<Avalonia.Controls.Slider>("Scrub").Value);
        here.WaitUntilIdle();
        Assert.Equal(here.Window.Model.Playback.Total, here.Window.Model.Playback.At);
    });

    [Fact]
    public Task AUTOSEQUENCE_lights_up_one_contour_after_the_other() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var seen = new SortedSet<int>();
        here.Commands.SequenceAnimation.Changed += (_, _) => seen.Add(here.Commands.SequenceAnimation.Moves ?? 0);
        here.Enter("AUTOWALK", "1", "AUTOSEQUENCE");

        var lit = here.Window.Canvas.EngravedMoves; // the walk pauses at the first discontinuity, and the part before it stays highlighted
        Assert.Equal(here.Commands.SequenceAnimation.Moves, lit);
        Assert.True(lit > 0);
        here.Enter("All");
        Assert.Equal(0, here.Window.Canvas.EngravedMoves);
        Assert.Equal(here.Desk.Derived.Job!.Toolpath.Strokes.Sum(stroke => stroke.Moves.Count), seen.Max);
        Assert.True(seen.Count > 10);
    });

    [Fact]
    public Task The_thumb_stands_in_the_middle_of_its_bar() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var thumb = here.Find<Avalonia.Controls.Slider>("Scrub").GetVisualDescendants().OfType<Avalonia.Controls.Primitives.Thumb>().First();
        var button = here.MiddleOf(here.Find<Avalonia.Controls.Button>("PlayButton"));

        Assert.InRange(here.MiddleOf(thumb).Y - button.Y, -1.0, 1.0);
    });

    [Fact]
    public Task A_click_on_a_row_moves_the_tool_to_its_beginning() => fixture.WithOperator(here =>
    {
        Prepare(here);
        here.Click(RowAt(here, "RowList", 3));

        Assert.Equal(here.Commands.Derivation.Current.Motion!.TimeOfRow(3)!.Value, here.Desk.Derived.AtSeconds, 6);
        Assert.Equal(3, here.Desk.Derived.RowUnderTool);
    });

    [Fact]
    public Task A_click_on_a_contour_or_a_program_line_moves_the_tool_there() => fixture.WithOperator(here =>
    {
        Prepare(here);
        here.Click(RowAt(here, "ContourList", 2));
        Assert.Equal(2, here.Desk.Derived.StrokeUnderTool);

        here.Show("Program");
        var lines = here.Find<ListBox>("LineList");
        var first = lines.GetRealizedContainers().Select(lines.IndexFromContainer).Min();
        here.Click(lines.ContainerFromIndex(first + 1)!);

        Assert.Equal(here.Commands.Derivation.Current.Motion!.TimeOfLine(first + 2)!.Value, here.Desk.Derived.AtSeconds, 6);
    });

    [Fact]
    public Task A_picked_entity_is_selected_and_the_tool_goes_there() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Until(() => here.Window.Canvas.IsUpToDate);
        var canvas = here.Window.Canvas;
        var entity = here.Commands.Derivation.Current.Sequence!.Table.EntityIndexOf(2);
        canvas.Commands!.PickAt(default, entity, canvas.Scene!.Drawing, remove: false);
        here.WaitUntilIdle();

        Assert.Null(here.Window.Canvas.PlaybackPosition); // the entity was picked, not played
        Assert.Equal([entity], here.Commands.Document.Current.Selection);
        Assert.Equal(here.Commands.Derivation.Current.Motion!.TimeOfEntity(entity)!.Value, here.Desk.Derived.AtSeconds, 6);
    });

    [Fact]
    public Task At_full_speed_it_plays_to_the_end() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Click(SpeedButton(here, "max"));
        here.Click(here.Find<Button>("PlayButton"));
        here.Until(() => !here.Commands.Playback.IsPlaying);
        here.Step();

        Assert.Equal(here.Window.Model.Playback.Total, here.Window.Model.Playback.At, 6);
        Assert.Equal(here.Window.Model.Playback.Total, here.Find<Slider>("Scrub").Value, 3);
        Assert.Null(here.Window.Canvas.PlaybackPosition);
    });

    [Fact]
    public Task Steps_go_from_contour_to_contour() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Click(here.Find<Button>("ForwardButton"));
        here.Click(here.Find<Button>("ForwardButton"));
        Assert.Equal(2, here.Desk.Derived.StrokeUnderTool);
        here.Click(here.Find<Button>("BackButton"));

        Assert.Equal(1, here.Desk.Derived.StrokeUnderTool);
    });

    private static void Prepare(Operator here)
    {
        here.Open("gasket.dxf");
        here.Show("Contours");
        here.Show("Table");
    }

    private static Control RowAt(Operator here, string list, int index)
    {
        here.Find<ListBox>(list).ScrollIntoView(index);
        here.Step();
        return here.Find<ListBox>(list).ContainerFromIndex(index)!;
    }

    private static Avalonia.Controls.Primitives.ToggleButton SpeedButton(Operator here, string name) =>
        here.Find<ItemsControl>("SpeedList").GetVisualDescendants().OfType<Avalonia.Controls.Primitives.ToggleButton>().Single(button => button.Content as string == name);
}
