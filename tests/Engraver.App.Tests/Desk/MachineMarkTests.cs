using Avalonia.Controls;
using Avalonia.Input;
using Engraver.App.Canvas;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Desk;

/// <summary>The canvas shows the position of the machine, whatever moves it.</summary>
[Collection(DesktopCollection.Name)]
public sealed class MachineMarkTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_jog_moves_the_mark_and_leaves_a_trail() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        Assert.Null(here.Window.Canvas.Machine);
        here.Enter("CNCCONNECT", "sim:?speed=5");
        Assert.Equal(Point2D.Origin, Mark(here).Place);
        here.Enter("CNCZERO", "All", "CNCJOG", "20,20");
        Comes(here, 20, 20);

        Assert.True(Mark(here).IsCertain);
        Assert.Null(here.Window.Canvas.PlaybackPosition);
        Assert.True(Mark(here).Trail.Count > 1);
        Assert.Equal(Point2D.Origin, Mark(here).Trail[0]);
        here.Enter("CNCGOTO", "Work", "5,0");
        Comes(here, 5, 0);
        here.Enter("CNCDISCONNECT");
        Assert.Null(here.Window.Canvas.Machine);
    });

    /// <summary>Without an origin the position in the drawing is unknown: the mark moves with the machine in machine coordinates, with a note.</summary>
    [Fact]
    public Task Without_an_origin_the_mark_is_not_certain_until_zero_is_set() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5", "CNCJOG", "20,20");
        Comes(here, 20, 20);
        here.Until(() => !Mark(here).IsCertain);

        Assert.Contains("CNCZERO", here.Find<TextBlock>("MachineNoteText").Text, StringComparison.Ordinal);
        here.Enter("CNCZERO", "All");
        here.Until(() => Mark(here).IsCertain);
        Assert.Equal(Point2D.Origin, Mark(here).Place);
        Assert.Equal(new Point2D(-20, -20), Mark(here).InDrawing(Mark(here).Trail[0]));
        Assert.False(here.Find<Border>("MachineNote").IsVisible);
    });

    [Fact]
    public Task In_a_drawing_in_inches_it_is_where_the_origin_puts_it() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5", "CNCJOG", "3,4", "CNCZERO", "All", "CNCJOG", "25.4,50.8");
        Comes(here, 1, 2);
    });

    /// <summary>The zero moves during homing: positions before and after it are not joined.</summary>
    [Fact]
    public Task Homing_is_shown_and_begins_a_new_trail() => fixture.WithOperator(here =>
    {
        here.Enter("CNCPROFILE", "machine-laser.json");
        here.Open("paper-001.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5", "CNCMOTORS", "ON", "CNCJOG", "1,1");
        here.Until(() => Mark(here).Trail.Count > 1);
        Assert.False(Mark(here).IsCertain);
        var moved = Mark(here).At;
        here.Enter("CNCHOME", "Yes");
        here.Until(() => here.Commands.Machine.Connection.IsHomed == true && !here.Commands.Machine.IsRunning);
        here.Step();

        Assert.NotEqual(moved, Mark(here).At);
        Assert.DoesNotContain(moved, Mark(here).Trail);
    });

    [Fact]
    public Task A_job_moves_the_mark_and_after_a_stop_it_stays_there_beside_the_playback() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.Running, ToolCommanded: true } && here.Window.Model.Machine.Feed is not "–" and not "0");
        Assert.Null(here.Window.Canvas.PlaybackPosition);
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();

        var (place, mark) = (here.Commands.Machine.Status.WorkPosition!.Value, Mark(here).Place);
        Assert.True(place.DistanceTo(default) > 0.1);
        Assert.Equal(place.X, mark.X * 25.4, 6); // the gasket is drawn in inches
        Assert.Equal(place.Y, mark.Y * 25.4, 6);
        Assert.Null(here.Window.Canvas.Highlight);
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 2;
        here.Step();
        Assert.Equal(here.Desk.Derived.Moment!.Value.Position.X, here.Window.Canvas.PlaybackPosition!.Value.X * 25.4, 6);
        Assert.NotNull(here.Window.Canvas.Highlight);
        Assert.Equal(mark, Mark(here).Place);
    });

    private static MachineMark Mark(Operator here) => here.Window.Canvas.Machine!;

    private static void Comes(Operator here, double x, double y) => here.Until(() => Mark(here).Place.DistanceTo(new Point2D(x, y)) < 0.001);
}
