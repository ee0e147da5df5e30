namespace Engraver.Workbench.Tests.Commands.Drafting;

public class PolylineCommandTests
{
    [Fact]
    public async Task Lines_and_smooth_arcs_closed()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PL", "0,0", "10,0", "A", "10,10", "L", "0,10", "A", "CL");

        Assert.Equal(["LwPolyline closed (0,0 10,0) (10,5 r5 from 270 by 180) (10,10 0,10) (0,5 r5 from 90 by 180)"], CurveText.Of(talk.State.Drawing));
        Assert.Null(talk.Session.Prompt.Command);
    }

    [Theory]
    [InlineData("A", "90", "10,10", "(0,10 r10 from 270 by 90)")]
    [InlineData("A", "90", "CE", "0,10", "(0,10 r10 from 270 by 90)")]
    [InlineData("A", "90", "R", "10", "45", "(0,10 r10 from 270 by 90)")]
    [InlineData("CE", "0,10", "10,10", "(0,10 r10 from 270 by 90)")]
    [InlineData("CE", "0,10", "A", "-90", "(0,10 r10 from 270 by -90)")]
    [InlineData("CE", "0,10", "L", "10", "(0,10 r10 from 270 by 60)")]
    [InlineData("D", "90", "10,0", "(5,0 r5 from 180 by -180)")]
    [InlineData("R", "10", "10,10", "(0,10 r10 from 270 by 90)")]
    [InlineData("R", "10", "10,-10", "(0,-10 r10 from 90 by -90)")]
    [InlineData("R", "10", "A", "90", "45", "(0,10 r10 from 270 by 90)")]
    [InlineData("S", "5,5", "10,0", "(5,0 r5 from 180 by -180)")]
    [InlineData("10,10", "(0,10 r10 from 270 by 90)")]
    public async Task Arcs_in_every_way(params string[] inputsAndArc)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync(["PLINE", "0,0", "A", .. inputsAndArc[..^1], ""]);

        Assert.Equal([$"LwPolyline {inputsAndArc[^1]}"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Length_goes_straight_on_and_undo_takes_segments_back()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PLINE", "0,0", "3,4", "L", "5", "A", "10,0", "U", "L", "@0,1", "");
        Assert.Equal(["LwPolyline (0,0 3,4) (3,4 6,8) (6,8 6,9)"], CurveText.Of(talk.State.Drawing));
        await talk.TypeAsync("U");

        Assert.Empty(CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Close_by_a_line_comes_with_the_second_segment()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PL", "0,0", "4,0");
        Assert.Equal("Specify next point or [Arc/Length/Undo]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("4,3");
        Assert.Equal("Specify next point or [Arc/Close/Length/Undo]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("C");

        Assert.Equal(["LwPolyline closed (0,0 4,0) (4,0 4,3) (4,3 0,0)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Closing_at_the_start_adds_no_segment_without_length()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PL", "0,0", "4,0", "4,3", "0,0", "C");

        Assert.Equal(["LwPolyline closed (0,0 4,0) (4,0 4,3) (4,3 0,0)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Nothing_but_a_start_leaves_no_polyline_and_no_step()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("PL", "0,0", "");

        Assert.Equal((4, "OPEN"), (talk.State.Drawing!.Entities.Count, Assert.Single(talk.Session.Document.UndoNames)));
    }

    [Fact]
    public async Task Esc_keeps_the_segments_that_are_drawn()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PL", "0,0", "4,0", "4,3");
        await talk.Session.CancelAsync();

        Assert.Equal(["LwPolyline (0,0 4,0) (4,0 4,3)"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task An_arc_straight_ahead_is_none()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("PL", "0,0", "A", "5,0");

        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);
        Assert.Empty(CurveText.Of(talk.State.Drawing));
    }
}
