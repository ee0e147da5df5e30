using Engraver.Core.Geometry;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Tests.Commands;

public class ViewCommandTests
{
    [Fact]
    public async Task Zoom_takes_a_window_a_scale_and_every_option()
    {
        await using var talk = CommandTestSession.WithDrawing();
        talk.Session.View.SetAspect(1.0);
        await talk.TypeAsync("Z", "0,0", "10,4");
        Assert.Equal((new Point2D(5, 2), 10.0), (View(talk).Centre, View(talk).Height));
        await talk.TypeAsync("ZOOM", "2x");
        Assert.Equal(5.0, View(talk).Height);
        await talk.TypeAsync("Z", "S", "0.5X", "Z", "C", "1,2", "8");
        Assert.Equal((new Point2D(1, 2), 8.0), (View(talk).Centre, View(talk).Height));
        await talk.TypeAsync("Z", "P", "Z", "P");
        Assert.Equal(5.0, View(talk).Height);
        await talk.TypeAsync("Z", "1");
        Assert.Equal(38.0, View(talk).Height, precision: 9); // 0 to 38 across: the whole drawing
        await talk.TypeAsync("Z", "W", "1,1", "3,3", "Z", "E");
        Assert.True(View(talk).Window.Contains(new Bounds2D(0, 0, 38, 8)));
        await talk.TypeAsync("Z", "O", "H", "A3", "");
        Assert.Equal(new Point2D(20, 5), View(talk).Centre);
        Assert.Empty(talk.Session.Document.UndoNames.Skip(1));
    }

    [Fact]
    public async Task A_zoom_inside_another_command_leaves_that_command_waiting()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MOVE", "L", "", "0,0", "'Z", "10X");

        Assert.Equal("MOVE", talk.Session.Prompt.Command);
        Assert.Equal(21.0, View(talk).Height, precision: 9);
        await talk.TypeAsync("'ZOOM");
        Assert.StartsWith(">>Specify corner of window, enter a scale factor (nX) or [All/", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.NotNull(talk.Session.Prompt.PointRequest);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-2X")]
    [InlineData("x")]
    [InlineData("big")]
    public async Task A_scale_that_is_none_is_asked_for_again(string typed)
    {
        await using var talk = CommandTestSession.WithDrawing();

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("Z", typed));
        Assert.Equal("ZOOM", talk.Session.Prompt.Command);
    }

    [Fact]
    public async Task Drawing_aids_are_switched_by_commands_and_by_their_variables()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("GRID", "2.5", "SNAP", "ON", "ORTHO", "ON", "OSNAP", "end,center", "THEME", "Light", "DYNAMICINPUT", "OFF");

        Assert.Equal((2.5, true, true, true, 5, DesktopTheme.Light, false), (View(talk).GridSpacing, View(talk).Grid, View(talk).Snap, View(talk).Ortho, View(talk).ObjectSnapModes, View(talk).Theme, View(talk).DynamicInput));
        await talk.TypeAsync("ORTHOMODE", "0", "GRIDMODE", "0", "SNAPMODE", "0", "OSMODE", "32", "OSNAP", "OFF");
        Assert.Equal((false, false, false, 32, false), (View(talk).Ortho, View(talk).Grid, View(talk).Snap, View(talk).ObjectSnapModes, View(talk).ObjectSnap));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OSNAP", "END,XYZ"));
    }

    [Fact]
    public async Task A_variable_shows_its_value_and_keeps_its_limits()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CURSORSIZE");
        Assert.Equal("Enter new value for CURSORSIZE <5>:", talk.Session.Prompt.Text);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("101"));
        await talk.TypeAsync("100");

        Assert.Equal(100.0, talk.Session.Settings.Current.Variables["CURSORSIZE"]);
        await talk.TypeAsync("OPTIONS", "PICKBOX", "9");
        Assert.Equal(9.0, talk.Session.Settings.Current.Variables["PICKBOX"]);
        Assert.Contains("CNCMAXERR     0.001", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task With_the_echo_off_only_results_are_said()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CMDECHO", "0");
        var echoes = 0;
        talk.Session.MessageWritten += (_, message) => echoes += message.Kind == MessageKind.Echo ? 1 : 0;
        await talk.TypeAsync("ID", "1,2");
        Assert.Equal(0, echoes);
        await talk.TypeAsync("CMDECHO", "1", "ID", "1,2");
        Assert.Equal(2, echoes);
    }

    [Theory]
    [InlineData("D", CanvasLayers.Drawing)]
    [InlineData("C", CanvasLayers.Contours)]
    [InlineData("ON", CanvasLayers.OrderNumbers)]
    [InlineData("SP", CanvasLayers.StartPoints)]
    [InlineData("R", CanvasLayers.Rapids)]
    [InlineData("CUTPATH", CanvasLayers.CutPath)]
    [InlineData("F", CanvasLayers.Findings)]
    [InlineData("M", CanvasLayers.Machine)]
    [InlineData("E", CanvasLayers.Engraved)]
    [InlineData("recorded", CanvasLayers.Recorded)]
    [InlineData("WO", CanvasLayers.WorkOrigin)]
    public async Task Every_layer_of_meaning_has_a_switch(string typed, CanvasLayers layer)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SHOW", "All", "SHOW", typed, "OFF");
        Assert.Equal(CanvasLayers.All & ~layer, View(talk).Shown);
        await talk.TypeAsync("SHOW", typed, "");
        Assert.Equal(CanvasLayers.All, View(talk).Shown);
    }

    [Fact]
    public async Task Pan_moves_by_two_points_or_by_a_displacement()
    {
        await using var talk = CommandTestSession.WithDrawing();
        talk.Session.View.SetCentre(new Point2D(0, 0), 10);
        await talk.TypeAsync("PAN", "1,1", "4,5");
        Assert.Equal(new Point2D(-3, -4), View(talk).Centre);
        await talk.TypeAsync("P", "1,1", "");
        Assert.Equal(new Point2D(-4, -5), View(talk).Centre);
    }

    [Fact]
    public async Task A_drawing_opens_in_the_view_in_which_it_was_left()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        Assert.True(View(talk).Window.Contains(talk.Session.View.ExtentsOf(talk.State.Drawing!)));
        await talk.TypeAsync("Z", "C", "3,4", "2", "OPEN", CommandTestSession.Sample("paper-001.dxf"), "RECENT", "2");

        Assert.EndsWith("gasket.dxf", talk.State.Drawing!.FileName, StringComparison.Ordinal);
        Assert.Equal((new Point2D(3, 4), 2.0), (View(talk).Centre, View(talk).Height));
        Assert.Equal(["gasket.dxf", "paper-001.dxf"], talk.Session.Settings.Current.RecentFiles.Select(Path.GetFileName));
    }

    [Fact]
    public async Task A_drawing_that_is_saved_under_a_name_is_among_the_recent_ones()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("NEW", "LINE", "0,0", "1,1", "", "SAVEAS", "new.dxf");
        Assert.Equal(["new.dxf"], talk.Session.Settings.Current.RecentFiles.Select(Path.GetFileName));
        Assert.True(Path.IsPathRooted(talk.Session.Settings.Current.RecentFiles[0]));
    }

    private static ViewState View(CommandTestSession talk) => talk.Session.View.Current;
}
