using Engraver.Core.Drawings;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Drafting;

public class LineCommandTests
{
    [Fact]
    public async Task Lines_from_point_to_point_absolute_relative_and_polar_in_a_drawing_that_begins_by_itself()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("L", "10,10", "@5,0", "@10<90", "#0,0", "");

        Assert.Equal(["Line (10,10 15,10)", "Line (15,10 15,20)", "Line (15,20 0,0)"], CurveText.Of(talk.State.Drawing));
        Assert.Equal("Drawing1.dxf", talk.State.Drawing!.FileName);
        Assert.True(talk.Session.Document.IsEdited);
    }

    [Fact]
    public async Task The_whole_command_is_one_step_and_undo_inside_takes_back_one_line()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("LINE", "0,50", "1,50", "2,50", "U", "3,50", "");
        Assert.Equal(["Line (0,50 1,50)", "Line (1,50 3,50)"], CurveText.Of(talk.State.Drawing)[4..]);
        await talk.TypeAsync("U");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("REDO");
        Assert.Equal(6, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task Undo_back_to_the_first_point_leaves_no_step_and_says_so_when_nothing_is_left()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("LINE", "0,50", "1,50", "U", "U");
        Assert.Contains("already undone", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("");

        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        Assert.Equal(["OPEN"], talk.Session.Document.UndoNames);
    }

    [Fact]
    public async Task Close_comes_with_the_third_point_and_ends_the_command()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("L", "0,0", "4,0");
        Assert.Equal("Specify next point or [Undo]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("4,3");
        Assert.Equal("Specify next point or [Close/Undo]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("C");

        Assert.Equal("Line (4,3 0,0)", CurveText.Of(talk.State.Drawing)[^1]);
        Assert.Null(talk.Session.Prompt.Command);
    }

    [Fact]
    public async Task Esc_keeps_what_is_drawn_as_in_AutoCAD()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("LINE", "0,50", "1,50", "2,50");
        await talk.Session.CancelAsync();
        Assert.Equal(6, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("U");

        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task The_same_point_twice_draws_nothing_and_is_asked_for_again()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("L", "1,1", "1,1");
        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("2,2", "");

        Assert.Equal(["Line (1,1 2,2)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Enter_goes_on_from_the_last_line_and_straight_on_from_the_last_arc()
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("L", ""));
        Assert.Contains("No line or arc to continue", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("L", "0,0", "10,0", "", "L", "", "10,5", "", "ARC", "", "0,5", "LINE", "", "7", "");

        Assert.Equal(["Line (0,0 10,0)", "Line (10,0 10,5)", "Arc (5,5 r5 from 0 by 180)", "Line (0,5 0,-2)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task A_ghost_stands_from_the_last_point_to_the_cursor()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("L", "1,1");
        var aim = talk.Session.Prompt.PointRequest!;

        Assert.Equal((new(1, 1), new(8, 9)), (aim.From!.Value, Assert.Single(aim.Ghost!(new(8, 9))).End));
    }

    [Fact]
    public async Task New_curves_lie_on_the_current_layer_in_its_colour_and_have_handles_of_their_own()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var drawing = talk.State.Drawing!;
        talk.Session.Document.Commit("LAYER", talk.State with { Drawing = drawing with { Layers = [.. drawing.Layers, new Layer("Marks", true, false, true) { Colour = DrawingColour.FromCode62(1) }] } });
        await talk.TypeAsync("CLAYER", "Marks", "L", "0,50", "1,50", "2,50", "");
        drawing = talk.State.Drawing!;

        Assert.All([4, 5], index => Assert.Equal(("Marks", true, 1), (drawing.Layers[drawing.Entities[index].Layer].Name, drawing.Entities[index].Colour.IsByLayer, drawing.ColourOf(index).Index)));
        Assert.Equal(drawing.Entities.Count, Enumerable.Range(0, drawing.Entities.Count).Select(index => drawing.Entities[index].Handle).Distinct().Count());
    }

    [Fact]
    public async Task A_coordinate_beyond_every_drawing_is_refused_with_a_sentence()
    {
        await using var talk = new CommandTestSession();

        Assert.Contains("exceed 1E+100", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("L", "0,0", "5,0", "1e200,0")).Message, StringComparison.Ordinal);
        Assert.Equal(["Line (0,0 5,0)"], CurveText.Of(talk.State.Drawing));
    }
}
