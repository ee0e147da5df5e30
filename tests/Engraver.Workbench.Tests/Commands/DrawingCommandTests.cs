using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

public class DrawingCommandTests
{
    [Fact]
    public async Task Open_reads_a_drawing_and_undo_brings_back_the_one_before()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        var first = talk.State;
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "U");

        Assert.Same(first, talk.State);
        await talk.TypeAsync("U");
        Assert.Same(first, talk.State);
        Assert.Contains("Everything has been undone.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_is_no_drawing_is_not_opened_and_the_old_one_stays()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State;
        await File.WriteAllTextAsync(talk.PathOf("text.dxf"), "hello");

        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OPEN", "text.dxf")).Reason);
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OPEN", "nowhere.dxf")).Reason);
        Assert.Same(before, talk.State);
    }

    [Fact]
    public async Task A_drawing_of_texts_with_a_damaged_curve_is_opened_with_its_error()
    {
        await using var talk = new CommandTestSession();
        var damaged = DxfText.WithEntities((0, "TEXT"), (8, "0"), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A"), (0, "LINE"), (8, "0"), (10, "x"), (20, 0.0), (11, 9.0), (21, 0.0));
        await File.WriteAllBytesAsync(talk.PathOf("text.dxf"), damaged.ToAscii());
        await talk.TypeAsync("OPEN", "text.dxf");

        Assert.Single(talk.State.Drawing!.Texts);
        Assert.True(talk.State.Drawing!.HasErrors);
    }

    [Fact]
    public async Task Without_a_drawing_every_command_that_needs_one_says_so()
    {
        foreach (var name in new[] { "MOVE", "ERASE", "ROTATE", "SCALE", "MIRROR", "REVERSE", "LIST", "SELECT", "PROPERTIES", "LAYER", "CHECK", "TABLE", "ENTER", "AUTOSEQUENCE", "DISCONTINUITIES", "POST", "PLOT", "CNCSIM", "CLOSE", "TOOLSTART" })
        {
            await using var talk = new CommandTestSession();

            Assert.Contains("No drawing is open", Assert.IsType<InputResult.Failed>(await talk.TypeAsync(name)).Message, StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData("ALL", 4)]
    [InlineData("L", 1)]
    [InlineData("W|-1,-1|11,10", 2)]
    [InlineData("W|-1,-1|9,10", 1)]
    [InlineData("C|-1,-1|9,10", 2)]
    [InlineData("22,-1|33,9", 0)]
    [InlineData("33,9|16,-1", 2)]
    [InlineData("20,8", 1)]
    [InlineData("H|a3", 1)]
    [InlineData("LA|0", 4)]
    [InlineData("ALL|R|L", 3)]
    [InlineData("ALL|R|L|A|L", 4)]
    [InlineData("L|ALL|U", 1)]
    public async Task Objects_are_selected_as_in_a_CAD_program(string inputs, int count)
    {
        await using var talk = CommandTestSession.WithDrawing();
        var result = await talk.TypeAsync(["SELECT", .. inputs.Split('|'), ""]);

        Assert.Equal(count, talk.State.Selection.Count);
        Assert.Equal(count > 0, result is InputResult.Done);
    }

    [Fact]
    public async Task Selecting_tells_found_duplicate_and_total()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SELECT", "L", "ALL", "");

        Assert.Contains("4 found (1 duplicate), 4 total", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_is_selected_before_the_command_is_taken_and_Previous_takes_it_again()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SELECT", "H", "A1", "", "MOVE", "0,0", "0,7");
        Assert.Equal(7, StartOf(talk, 0).Y);
        Assert.Empty(talk.State.Selection);
        await talk.TypeAsync("MOVE", "P", "", "D", "0,1");

        Assert.Equal(8, StartOf(talk, 0).Y);
        Assert.Equal(new Point2D(30, 0), StartOf(talk, 3));
    }

    [Fact]
    public async Task Base_point_alone_is_the_displacement()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("M", "ALL", "", "2,3", "");

        Assert.Equal(new Point2D(2, 3), StartOf(talk, 0));
    }

    [Fact]
    public async Task Rotating_by_reference_turns_the_reference_to_the_new_angle()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("RO", "ALL", "", "0,0", "R", "30", "120");

        Assert.Equal(new Point2D(0, 10), talk.State.Drawing!.Parts[0].InPlan().End);
    }

    [Fact]
    public async Task Scaling_a_copy_leaves_the_source()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SC", "H", "A3", "", "20,5", "C", "2");

        Assert.Equal((5, 3.0, 6.0), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Parts[2].D, talk.State.Drawing.Parts[talk.State.Drawing.Parts.Count - 1].D));
    }

    [Fact]
    public async Task Mirroring_keeps_the_source_unless_told_otherwise()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MI", "H", "A2", "", "0,0", "0,1", "");
        Assert.Equal(5, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("U", "MI", "H", "A2", "", "0,0", "0,1", "Yes");

        Assert.Equal((4, -5.0, -110.0), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Parts[1].A, talk.State.Drawing.Parts[1].F));
    }

    [Fact]
    public async Task A_mirror_line_of_one_point_and_a_move_out_of_range_change_nothing()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State;

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("MI", "ALL", "", "1,1", "1,1"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("M", "ALL", "", "0,0", "1e200,0"));
        Assert.Same(before.Drawing, talk.State.Drawing);
    }

    [Fact]
    public async Task Erasing_the_entering_entity_frees_the_order()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ENTER", "20,8");
        Assert.Equal(new ContourEntry.ByHandle("A3"), talk.State.Settings.Enter);
        await talk.TypeAsync("ERASE", "H", "A3", "");

        Assert.Null(talk.State.Settings.Enter);
        Assert.Equal(3, talk.State.Drawing!.Entities.Count);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("AUTOSEQUENCE"));
    }

    [Fact]
    public async Task A_layer_that_is_switched_off_is_neither_cut_nor_selected()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("nameplate.dxf"), "SELECT", "ALL", "");
        var all = talk.State.Selection.Count;
        await talk.Session.CancelAsync();
        await talk.TypeAsync("LAYER", "OFF", "rahmen", "", "SELECT", "ALL", "");

        Assert.True(talk.State.Selection.Count < all);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("LAYER", "OFF", "frame"));
        await talk.Session.CancelAsync();
        await talk.TypeAsync("U");
        Assert.All(talk.State.Drawing!.Layers.Where(layer => layer.Name == "Rahmen"), layer => Assert.True(layer.On));
    }

    [Theory]
    [InlineData("red", 1, null)]
    [InlineData("White", 7, null)]
    [InlineData("42", 42, null)]
    [InlineData("255, 128,0", null, 0xFF8000u)]
    public async Task A_layer_takes_a_colour_and_undo_takes_it_back(string typed, int? index, uint? rgb)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        var before = talk.State.Drawing!.Layers.ToArray();
        await talk.TypeAsync("LAYER", "Color", typed, "VENTS", "?", "");

        var layer = talk.State.Drawing!.Layers.Single(layer => layer.Name == "VENTS");
        Assert.Equal((index, rgb), (layer.Colour.Index, layer.Colour.Rgb));
        Assert.Contains($"{ColourName.Format(layer.Colour),-11}  VENTS", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U");
        Assert.Equal(before, talk.State.Drawing!.Layers);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("256")]
    [InlineData("1,2")]
    [InlineData("1,2,256")]
    [InlineData("1,2,3,x")]
    [InlineData("mauve")]
    public async Task What_is_no_colour_is_said_to_be_none(string typed)
    {
        await using var talk = CommandTestSession.WithDrawing();

        Assert.Contains("is not a colour", Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("LAYER", "C", typed)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task List_and_properties_tell_what_is_there()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("LIST", "H", "A2", "", "SELECT", "ALL", "", "PR");
        await talk.Session.CancelAsync();
        await talk.TypeAsync("PROPERTIES");

        Assert.Contains("ARC, handle A2, layer 0, length 7.6794\n    arc from 8.9392,4.3054 to 4.3054,8.9392, centre 5,5, radius 4, sweep 110", talk.Said, StringComparison.Ordinal);
        Assert.Contains("4 objects: 1 LINE, 1 ARC, 1 CIRCLE, 1 LWPOLYLINE", talk.Said, StringComparison.Ordinal);
        Assert.Contains("size 38 x", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_setting_is_typed_by_its_name_and_undone_like_everything_else()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CNCFEED");
        Assert.Equal("Enter new value for CNCFEED <1200>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("600", "CNCVA");
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("256001"));
        Assert.Equal(600, talk.State.Settings.Machine.FeedMmPerMinute);
        await talk.TypeAsync("U");

        Assert.Equal(1200, talk.State.Settings.Machine.FeedMmPerMinute);
    }

    [Fact]
    public async Task Points_are_drawing_units_and_the_stages_get_millimetres()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CNCUNITS", "1", "OPEN", CommandTestSession.Sample("paper-001.dxf"), "TOOLSTART", "2,1");

        Assert.Equal(new Point2D(50.8, 25.4), talk.State.Settings.Start);
        await talk.TypeAsync("TOOLSTART");
        Assert.Equal("2,1", talk.Session.Prompt.Default);
    }

    [Fact]
    public async Task Undo_takes_a_number_of_steps()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State;
        await talk.TypeAsync("M", "ALL", "", "1,0", "", "M", "P", "", "1,0", "", "UNDO", "2");

        Assert.Equal(Fingerprint.Of(before), Fingerprint.Of(talk.State));
        await talk.TypeAsync("REDO", "REDO", "REDO");
        Assert.Equal(2, StartOf(talk, 0).X);
        Assert.Contains("Everything has been redone.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Help_lists_every_command_and_explains_one()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("HELP", "", "HELP", "move");

        Assert.All(talk.Session.Catalog.All, info => Assert.Contains($"  {info.Name} ", talk.Said, StringComparison.Ordinal));
        Assert.Contains("MOVE: Moves objects by a displacement.\nAliases: M", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HELP", "fly"));
    }

    private static Point2D StartOf(CommandTestSession talk, int entity) => DrawingPick.Segments(talk.State.Drawing!, entity).First().Start;
}
