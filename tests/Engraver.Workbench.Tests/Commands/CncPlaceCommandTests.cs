using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCPLACE shows the open drawing as it is placed, without editing it.</summary>
public class CncPlaceCommandTests
{
    [Fact]
    public async Task The_placements_are_applied_in_their_order_and_undone()
    {
        await using var talk = await OpenAsync();
        var drawn = talk.State.Drawing!;
        await talk.TypeAsync("CNCPLACE", "MO", "10,5", "CNCPLACE", "R", "90", "CNCPLACE", "M", "Y", "CNCPLACE", "S", "2");

        var placed = DrawingFile.Open(drawn.FileName, talk.State.Settings, CancellationToken.None);
        Assert.Equal(new DrawingPlacement { Scale = 2.0, Mirror = MirrorAxis.Y, Rotation = Angle.FromDegrees(90.0), Move = new Vector2D(10.0, 5.0) }, talk.State.Settings.Placement);
        Assert.True(talk.State.Drawing!.Parts.HasRowsOf(placed.Parts, DrawingPart.AreSame));
        Assert.False(talk.Session.Document.IsEdited);
        Assert.Contains("Placement: scaled by 2, mirrored about the Y axis, rotated by 90 degrees, moved by 10,5 mm.", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("U", "U", "U", "U");
        Assert.Same(drawn, talk.State.Drawing);
        await talk.TypeAsync("CNCPLACE", "S", "3", "CNCPLACE", "N");
        Assert.Same(drawn, talk.State.Drawing);
        Assert.Equal(DrawingSettings.Default.Placement, talk.State.Settings.Placement);
    }

    [Fact]
    public async Task An_edit_is_made_in_placed_coordinates_and_stays_when_the_placement_ends()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "S", "2", "CNCPLACE", "R", "90", "CNCPLACE", "MO", "10,0", "LINE", "10,0", "10,40", "");
        Assert.True(talk.Session.Document.IsDrawingEdited);
        await talk.TypeAsync("CNCPLACE", "N");

        var line = talk.State.Drawing!.Parts[talk.State.Drawing.Parts.Count - 1];
        Assert.Equal((0.0, 0.0, 20.0, 0.0), (Math.Round(line.A, 9), Math.Round(line.B, 9), Math.Round(line.D, 9), Math.Round(line.E, 9)));
        Assert.True(talk.Session.Document.IsDrawingEdited);
    }

    [Fact]
    public async Task A_saved_drawing_has_the_placed_coordinates_and_no_placement()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "MO", "100,200", "SAVEAS", talk.PathOf("saved.dxf"));
        var saved = DrawingFile.Open(talk.PathOf("saved.dxf"), talk.State.Settings, CancellationToken.None);

        Assert.True(talk.State.Settings.Placement.IsNone && talk.State.Drawing!.Placement.IsNone);
        Assert.False(talk.Session.Document.IsEdited);
        Assert.Equal(talk.State.Drawing.Parts[0].A, saved.Parts[0].A);
        Assert.Contains("The file has the placed coordinates.", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U");
        Assert.True(talk.Session.Document.IsDrawingEdited);
    }

    [Fact]
    public async Task A_drawing_is_aligned_placed_on_its_blank_and_turned_over()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "K", "X");
        Assert.Contains("CNCPLACE needs the size of the blank: CNCPLACE.", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCPLACE", "B", "100,0", "100,80", "CNCPLACE", "K", "X", "CNCPLACE", "P", "CE");
        Assert.Equal(new DrawingPlacement { Blank = new Vector2D(100.0, 80.0), Back = MirrorAxis.X, Place = BlankPlace.Centre }, talk.State.Settings.Placement);

        await talk.TypeAsync("CNCPLACE", "AL", "0,0:90,0", "0,0:0,90");
        Assert.Equal((BlankPlace.None, new PointPair(default, new Point2D(90.0, 0.0))), (talk.State.Settings.Placement.Place, talk.State.Settings.Placement.Align));
        await talk.TypeAsync("CNCPLACE", "AL", "0,0:90,0", "0,0:0,91");
        Assert.Contains("differ by 1 mm", talk.Said, StringComparison.Ordinal);
        Assert.Contains("0,0 and 90,0 at 0,0 and 0,90, on a blank of 100 x 80 mm, on its back, turned about X", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_scale_is_a_factor_or_a_ratio()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "S", "1:0", "1:2");
        Assert.Equal(0.5, talk.State.Settings.Placement.Scale);
        Assert.Contains("1:0", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("CNCPLACE", "S", "");
        Assert.Equal(0.5, talk.State.Settings.Placement.Scale);
    }

    [Fact]
    public async Task Points_are_picked_on_the_drawing_as_shown_and_cut_where_they_are_picked_whatever_was_placed_before()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "S", "0.5", "CNCPLACE", "M", "X", "CNCPLACE", "R", "30", "CNCPLACE", "MO", "10,5", "CNCPLACE", "B", "100,80", "CNCPLACE", "K", "Y");
        Point2D[] drawn = [new(10.0, 10.0), new(70.0, 10.0)];
        Assert.NotEqual(new Point2D(20.0, 30.0), talk.State.Drawing!.Placed(drawn[0]));

        await talk.TypeAsync("CNCPLACE", "AL");
        Assert.Equal(PointPurpose.Place, talk.Session.Prompt.PointRequest!.Purpose);
        await talk.TypeAsync(Shown(0));
        Assert.Equal(PointPurpose.Place, talk.Session.Prompt.PointRequest!.Purpose);
        await talk.TypeAsync(Shown(0), Shown(1), "20,30", "@30<90");

        Assert.Contains("two different points", talk.Said, StringComparison.Ordinal);
        Assert.Equal([(20.0, 30.0), (20.0, 60.0)], drawn.Select(point => talk.State.Drawing!.Placed(point)).Select(point => (Math.Round(point.X, 4), Math.Round(point.Y, 4))));
        Assert.Equal((new Vector2D(10.0, 5.0), MirrorAxis.Y), (talk.State.Settings.Placement.Move, talk.State.Settings.Placement.Back));

        string Shown(int index) => PointPrompt.Format(talk.State.Drawing!.Placed(drawn[index]));
    }

    [Fact]
    public async Task The_position_of_the_machine_is_a_point()
    {
        await using var talk = await OpenAsync();
        Assert.Contains("CNCCONNECT", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCPLACE", "AL", "0,0", "90,0", "Machine")).Message, StringComparison.Ordinal);

        await talk.TypeAsync("CNCCONNECT", "sim:", "CNCGOTO", "12,-4", "CNCZERO", "All", "CNCGOTO", "32,6", "CNCPLACE", "AL", "0,0", "90,0", "Machine", "20,100");

        Assert.Equal([(20.0, 10.0), (20.0, 100.0)], new[] { default, new Point2D(90.0, 0.0) }.Select(point => talk.State.Drawing!.Placed(point)).Select(point => (Math.Round(point.X, 6), Math.Round(point.Y, 6))));
    }

    [Fact]
    public async Task The_placement_ends_with_the_drawing_and_is_not_set_without_one()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCPLACE", "MO", "1", "CNCPLACE", "S", "3", "OPEN", CommandTestSession.Sample("gasket.dxf"));

        Assert.True(talk.State.Settings.Placement.IsNone && talk.State.Drawing!.Placement.IsNone);
        await using var empty = new CommandTestSession();
        await empty.TypeAsync("CNCPLACE");
        Assert.Contains("No drawing is open", empty.Said, StringComparison.Ordinal);
    }

    private static async Task<CommandTestSession> OpenAsync()
    {
        var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("operation-plate.dxf"));
        return talk;
    }
}
