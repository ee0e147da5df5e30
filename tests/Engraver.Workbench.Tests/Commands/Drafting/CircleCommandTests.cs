using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Drafting;

public class CircleCommandTests
{
    [Theory]
    [InlineData("5,5", "3", "Circle (5,5 r3)")]
    [InlineData("5,5", "9,8", "Circle (5,5 r5)")]
    [InlineData("5,5", "D", "3", "Circle (5,5 r1.5)")]
    [InlineData("5,5", "D", "@4<0", "Circle (5,5 r2)")]
    [InlineData("2P", "1,2", "7,10", "Circle (4,6 r5)")]
    [InlineData("3P", "5,0", "0,5", "-5,0", "Circle (0,0 r5)")]
    public async Task In_every_way(params string[] inputsAndCircle)
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(["C", .. inputsAndCircle[..^1]]));

        Assert.Equal([inputsAndCircle[^1]], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Touching_two_lines_where_they_are_pointed_at()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("L", "0,0", "30,0", "", "L", "0,0", "0,30", "", "C", "T", "20,0", "0,20", "4");

        Assert.Equal("Circle (4,4 r4)", CurveText.Of(talk.State.Drawing)[^1]);
    }

    [Fact]
    public async Task A_radius_that_touches_nothing_is_asked_for_again()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("C", "0,0", "3", "C", "24,0", "3", "C", "TTR", "0,3", "24,3", "5");
        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("10");

        Assert.Equal("Circle (12,5 r10)", CurveText.Of(talk.State.Drawing)[^1]);
    }

    [Fact]
    public async Task The_last_radius_is_the_default_also_as_a_diameter_and_one_undo_takes_the_circle_back()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("CIRCLE");
        Assert.Equal("Specify center point for circle or [3P/2P/Ttr]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("0,0", "D", "7", "C", "20,0");
        Assert.Equal("Specify radius of circle or [Diameter] <3.5>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("D");
        Assert.Equal("Specify diameter of circle <7>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("");
        Assert.Equal(["Circle (0,0 r3.5)", "Circle (20,0 r3.5)"], CurveText.Of(talk.State.Drawing));
        await talk.TypeAsync("U");

        Assert.Equal(["Circle (0,0 r3.5)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task The_circle_is_seen_at_the_cursor_before_the_click()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("C", "5,5");

        Assert.Equal(5.0, Assert.Single(talk.Session.Prompt.PointRequest!.Ghost!(new(9, 8))).Arc.Radius, 12);
    }

    [Fact]
    public async Task Zero_is_no_radius()
    {
        await using var talk = new CommandTestSession();

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("C", "5,5", "0"));
        Assert.Empty(CurveText.Of(talk.State.Drawing));
    }
}
