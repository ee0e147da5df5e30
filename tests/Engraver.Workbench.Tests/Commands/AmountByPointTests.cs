using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>ROTATE and SCALE accept an amount by picking points, as in AutoCAD: from the base point, or for a reference between two points.</summary>
public class AmountByPointTests
{
    /// <summary>End of the line from 0,0 to 10,0 afterwards.</summary>
    [Theory]
    [InlineData(new[] { "ROTATE", "H", "A1", "", "0,0", "0,5" }, 0.0, 10.0)]
    [InlineData(new[] { "ROTATE", "H", "A1", "", "0,0", "@0,-3" }, 0.0, -10.0)]
    [InlineData(new[] { "ROTATE", "H", "A1", "", "0,0", "7<180" }, -10.0, 0.0)]
    [InlineData(new[] { "ROTATE", "H", "A1", "", "0,0", "R", "20,20", "@3,3", "0,9" }, 7.071068, 7.071068)]
    [InlineData(new[] { "ROTATE", "H", "A1", "", "0,0", "R", "45", "-9,0" }, -7.071068, 7.071068)]
    [InlineData(new[] { "SCALE", "H", "A1", "", "0,0", "3,4" }, 50.0, 0.0)]
    [InlineData(new[] { "SCALE", "H", "A1", "", "0,0", "R", "50,50", "@0,10", "0,25" }, 25.0, 0.0)]
    [InlineData(new[] { "SCALE", "H", "A1", "", "0,0", "0,0", "2" }, 20.0, 0.0)]
    [InlineData(new[] { "SCALE", "H", "A1", "", "0,0", "R", "5,5", "5,5", "5,7", "3" }, 15.0, 0.0)]
    public async Task An_amount_is_shown_by_a_place(string[] typed, double x, double y)
    {
        await using var talk = CommandTestSession.WithDrawing();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(typed));
        var end = talk.State.Drawing!.Parts[0].InPlan().End;

        Assert.Equal((x, y), (Math.Round(end.X, 6) + 0.0, Math.Round(end.Y, 6) + 0.0));
    }

    [Fact]
    public async Task What_was_shown_is_the_next_default()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ROTATE", "H", "A1", "", "0,0", "0,5", "ROTATE", "H", "A1", "", "0,0");

        Assert.Equal("90", talk.Session.Prompt.Default);
    }

    [Fact]
    public async Task A_length_of_nothing_is_refused_and_asked_for_again()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SCALE", "H", "A1", "", "4,4");

        Assert.Contains("0 is out of range", Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("4,4")).Message, StringComparison.Ordinal);
        Assert.Contains("is not a number or a point", Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("long")).Message, StringComparison.Ordinal);
        Assert.Equal("SCALE", talk.Session.Prompt.Command);
    }
}
