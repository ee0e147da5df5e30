using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Picked objects are highlighted at once, and the result of a click is previewed, on a line (A1, from 0,0 to 10,0), an arc, a circle (A3, 20,5,
/// radius 3) and a square.</summary>
public class EditingGhostTests
{
    [Fact]
    public async Task What_is_picked_lights_up_before_Enter_and_goes_out_when_it_is_removed()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MOVE", "5,0");
        Assert.Equal([0], talk.Session.HighlightedEntities);
        await talk.TypeAsync("20,8");
        Assert.Equal([0, 2], talk.Session.HighlightedEntities);
        await talk.TypeAsync("R", "5,0");
        Assert.Equal([2], talk.Session.HighlightedEntities);
        Assert.True(talk.Session.Prompt.PointRequest!.IsDeselecting);
        Assert.StartsWith("Remove objects", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("", "0,0");
        Assert.Equal([2], talk.Session.HighlightedEntities);
        Assert.Empty(talk.State.Selection);
        await talk.TypeAsync("1,1");
        Assert.Empty(talk.Session.HighlightedEntities);
    }

    [Fact]
    public async Task Esc_puts_out_what_was_picked()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ERASE", "ALL");
        Assert.Equal(4, talk.Session.HighlightedEntities.Count);
        await talk.Session.CancelAsync();
        Assert.Empty(talk.Session.HighlightedEntities);
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    public static TheoryData<string[], double[]> Ghosts => new()
    {
        { ["MOVE", "H", "A1", "", "1,1"], [6, 4, 16, 4] },
        { ["COPY", "H", "A1", "", "1,1"], [6, 4, 16, 4] },
        { ["COPY", "H", "A1", "", "1,1", "9,9"], [6, 4, 16, 4] },
        { ["MOVE", "H", "A1", "", "D"], [7, 5, 17, 5] },
        { ["ROTATE", "H", "A1", "", "7,1"], [8, -6, 8, 4] },
        { ["ROTATE", "H", "A1", "", "7,1", "R", "90"], [0, 0, 10, 0] },
        { ["SCALE", "H", "A1", "", "7,4"], [0, 0, 10, 0] },
        { ["SCALE", "H", "A1", "", "7,4", "R", "2"], [3.5, 2, 8.5, 2] },
        { ["MIRROR", "H", "A1", "", "7,0"], [14, 0, 4, 0] },
        { ["ARRAY", "H", "A1", "", "R", "1", "2", "5,5"], [2, 0, 12, 0] },
        { ["ARRAY", "H", "A1", "", "R", "2", "1", "5,5"], [0, 0, 10, 0] },
    };

    /// <summary>The line from 0,0 to 10,0 with the cursor at 7,5.</summary>
    [Theory]
    [MemberData(nameof(Ghosts))]
    public async Task Before_the_click_the_ghost_stands_where_the_object_would(string[] typed, double[] line)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync(typed);
        var ghost = Assert.Single(talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(7, 5)));

        Assert.True(ghost.Start.IsNear(new Point2D(line[0], line[1]), 1e-9) && ghost.End.IsNear(new Point2D(line[2], line[3]), 1e-9), $"{ghost.Start} {ghost.End}");
    }

    [Fact]
    public async Task A_polar_array_shows_its_items_around_the_cursor_and_around_the_centre()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ARRAY", "H", "A1", "", "PO");
        Assert.Equal(5, talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(7, 5)).Count);
        await talk.TypeAsync("0,0", "4");
        var preview = talk.Session.Prompt.Preview!(default);
        Assert.Equal([new Point2D(0, 10), new Point2D(-10, 0), new Point2D(0, -10)], preview.Select(segment => segment.End));
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task A_rectangular_array_takes_its_distances_from_a_unit_cell()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ARRAY", "H", "A1", "", "R", "2", "2", "5,5", "17,8");

        Assert.Equal([new(12, 0), new(0, 3), new Point2D(12, 3)], Enumerable.Range(4, 3).Select(index => DrawingPick.Segments(talk.State.Drawing!, index).Single().Start));
    }

    [Fact]
    public async Task A_large_selection_is_its_box_and_a_sample()
    {
        await using var talk = new CommandTestSession();
        var builder = new DrawingBuilder();
        for (var i = 0; i < 50_000; i++) builder.Line(i, 0, i, 100);
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = builder.Build() });
        await talk.TypeAsync("MOVE", "ALL", "", "0,0");
        var ghost = talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(1, 2));

        Assert.InRange(ghost.Count, 500, 1100);
        Assert.Contains(Segment.FromLine(new Point2D(1, 2), new Point2D(50_000, 2)), ghost);
        await talk.Session.CancelAsync();
        await talk.TypeAsync("ARRAY", "ALL", "", "R", "30", "30", "5,5");
        Assert.InRange(talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(1, 2)).Count, 4, 1100);
    }

    /// <summary>The first pick stays highlighted until the second point is entered, but not after the command.</summary>
    [Theory]
    [InlineData("FILLET", "5,0")]
    [InlineData("BREAK", "5,0")]
    [InlineData("MATCHPROP", "5,0")]
    [InlineData("OFFSET", "2", "5,0")]
    public async Task One_object_that_a_command_works_on_is_lit_up_and_a_miss_asks_again(string command, params string[] answers)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync(command);
        foreach (var answer in answers[..^1]) await talk.TypeAsync(answer);
        var question = talk.Session.Prompt.Text;
        await talk.TypeAsync("99,99");
        Assert.Equal((question, 0), (talk.Session.Prompt.Text, talk.Session.HighlightedEntities.Count));
        Assert.Contains("No object at this point", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync(answers[^1]);
        Assert.NotEqual(question, talk.Session.Prompt.Text);
        Assert.Equal([0], talk.Session.HighlightedEntities);
        await talk.Session.CancelAsync();
        Assert.Empty(talk.Session.HighlightedEntities);
    }

    [Theory]
    [InlineData("OFFSET", "2", "5,0", "3,7")]
    [InlineData("OFFSET", "50", "20,8", "20,5")]
    [InlineData("FILLET", "M", "R", "9", "5,0", "20,8")]
    [InlineData("FILLET", "M", "R", "1", "5,0", "5,0")]
    public async Task What_was_lit_up_goes_out_behind_it(string command, params string[] answers)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync([command, .. answers]);
        Assert.Equal((command, 0), (talk.Session.Prompt.Command, talk.Session.HighlightedEntities.Count));
    }

    [Fact]
    public async Task Copies_go_on_until_Enter_and_are_one_step_of_undo()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("COPY", "H", "A1", "", "0,0", "0,1");
        Assert.Equal("Specify second point or [Array/Exit/Undo] <Exit>:", talk.Session.Prompt.Text);
        Assert.Equal([0], talk.Session.HighlightedEntities);
        await talk.TypeAsync("0,2", "0,3", "U", "0,4", "");
        Assert.Equal([1.0, 2.0, 4.0], Enumerable.Range(4, talk.State.Drawing!.Entities.Count - 4).Select(index => DrawingPick.Segments(talk.State.Drawing!, index).Single().Start.Y));
        Assert.Null(talk.Session.Prompt.Command);
        await talk.TypeAsync("U");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("REDO");
        Assert.Equal(7, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task All_copies_can_be_taken_back_inside_and_Enter_at_first_takes_the_base_point_as_the_way()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("COPY", "H", "A1", "", "3,4", "0,1", "0,2", "U", "U", "U");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("U"));
        await talk.TypeAsync("");
        Assert.Equal(new Point2D(3, 4), DrawingPick.Segments(talk.State.Drawing!, 4).Single().Start);
        await talk.TypeAsync("U", "COPY", "H", "A1", "", "0,0", "A", "4", "0,2", "");
        Assert.Equal([2.0, 4.0, 6.0], Enumerable.Range(4, 3).Select(index => DrawingPick.Segments(talk.State.Drawing!, index).Single().Start.Y));
    }

    [Fact]
    public async Task Defaults_are_shown_short_and_taken_whole()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SCALE", "H", "A3", "", "20,5", "R", "3", "1", "SCALE", "H", "A3", "", "20,5", "1.23456789012345", "SCALE", "H", "A3", "", "20,5");
        Assert.EndsWith("<1.2346>:", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("");
        Assert.Equal(1.2345678901 * 1.23456789012345, DrawingPick.Segments(talk.State.Drawing!, 2).Single().Arc.Radius, 1e-9);
    }
}
