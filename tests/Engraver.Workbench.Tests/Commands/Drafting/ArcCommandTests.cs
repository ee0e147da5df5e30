using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Drafting;

public class ArcCommandTests
{
    /// <summary>The quarter from 10,0 to 0,10 about the origin, in every method of AutoCAD.</summary>
    [Theory]
    [InlineData("10,0", "7.0710678118654755,7.0710678118654755", "0,10", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "C", "0,0", "0,99", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "C", "0,0", "A", "90", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "C", "0,0", "A", "-90", "Arc (0,0 r10 from 270 by 90)")]
    [InlineData("10,0", "C", "0,0", "L", "10", "Arc (0,0 r10 from 0 by 60)")]
    [InlineData("10,0", "C", "0,0", "L", "-10", "Arc (0,0 r10 from 0 by 300)")]
    [InlineData("10,0", "E", "0,10", "0,0", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "E", "0,10", "A", "90", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "E", "0,10", "D", "90", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "E", "0,10", "D", "10,7", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "E", "0,10", "R", "10", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("10,0", "E", "0,10", "R", "-10", "Arc (10,10 r10 from 270 by 270)")]
    [InlineData("C", "0,0", "10,0", "0,5", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("C", "0,0", "10,0", "A", "90", "Arc (0,0 r10 from 0 by 90)")]
    [InlineData("C", "0,0", "10,0", "L", "20", "Arc (0,0 r10 from 0 by 180)")]
    public async Task In_every_way(params string[] inputsAndArc)
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(["A", .. inputsAndArc[..^1]]));

        Assert.Equal([inputsAndArc[^1]], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Prompts_are_those_of_AutoCAD()
    {
        await using var talk = new CommandTestSession();
        var prompts = new List<string>();
        foreach (var input in new[] { "ARC", "0,0", "E", "10,0" })
        {
            await talk.TypeAsync(input);
            prompts.Add(talk.Session.Prompt.Text);
        }

        Assert.Equal(["Specify start point of arc or [Center]:", "Specify second point of arc or [Center/End]:", "Specify end point of arc:", "Specify center point of arc or [Angle/Direction/Radius]:"], prompts);
    }

    [Fact]
    public async Task A_clockwise_arc_is_kept_counter_clockwise_and_gone_on_from_where_it_was_drawn_to()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("ARC", "-10,0", "0,10", "10,0", "ARC", "", "20,0", "U");
        Assert.Equal(["Arc (0,0 r10 from 0 by 180)"], CurveText.Of(talk.State.Drawing));
        await talk.TypeAsync("REDO");

        Assert.Equal("Arc (15,0 r5 from 180 by 180)", CurveText.Of(talk.State.Drawing)[^1]);
    }

    [Fact]
    public async Task What_makes_no_arc_is_asked_for_again_and_esc_leaves_the_drawing_as_it_was()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ARC", "0,0", "1,1", "2,2");
        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);
        Assert.Equal("Specify end point of arc:", talk.Session.Prompt.Text);
        await talk.Session.CancelAsync();

        Assert.Equal((4, "OPEN"), (talk.State.Drawing!.Entities.Count, Assert.Single(talk.Session.Document.UndoNames)));
    }

    [Fact]
    public async Task Nothing_to_go_on_from_is_said()
    {
        await using var talk = new CommandTestSession();

        Assert.Contains("No line or arc to continue", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("ARC", "")).Message, StringComparison.Ordinal);
    }
}
