using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>The animation of AUTOSEQUENCE on a drawing of a line, an arc, a circle and a square.</summary>
public class AutoSequenceTests
{
    [Fact]
    public async Task Without_AUTOWALK_a_console_neither_walks_nor_asks()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var walked = Walked(talk);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("AUTOSEQUENCE"));
        Assert.Empty(walked);
    }

    [Fact]
    public async Task Each_contour_lights_up_and_a_discontinuity_is_told_with_its_place_before_it_goes_on()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var walked = Walked(talk);
        await talk.TypeAsync("AUTOWALK", "1", "AUTOSEQUENCE");

        Assert.Contains("Contour 1 ends at a discontinuity at 10, 0 mm. The nearest free end point is", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.Equal(1, talk.Session.SequenceAnimation.Moves);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("All"));
        Assert.Null(talk.Session.SequenceAnimation.Moves);
        Assert.Equal(4, walked.Count(moves => moves is not null));
        Assert.Equal(walked.Order(Comparer<int?>.Create((a, b) => (a ?? int.MaxValue).CompareTo(b ?? int.MaxValue))), walked);
        Assert.Null(walked[^1]);
    }

    [Fact]
    public async Task No_ends_the_walk_at_the_discontinuity_and_keeps_the_order()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CNCORDER", "Drawn", "AUTOWALK", "1", "AUTOSEQUENCE");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("No"));
        Assert.EndsWith("Stopped after contour 1 of 4.", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.SequenceAnimation.Moves);
        Assert.Equal(Engraver.Core.Sequencing.Ordering.StrokeOrder.Nearest, talk.State.Settings.Order);
    }

    private static List<int?> Walked(CommandTestSession talk)
    {
        var walked = new List<int?>();
        talk.Session.SequenceAnimation.Changed += (_, _) => walked.Add(talk.Session.SequenceAnimation.Moves);
        return walked;
    }
}
