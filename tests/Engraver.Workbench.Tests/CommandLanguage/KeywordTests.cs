using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Tests.CommandLanguage;

public class KeywordTests
{
    [Theory]
    [InlineData("Window", "w", true)]
    [InlineData("Window", "WIN", true)]
    [InlineData("Window", "wx", false)]
    [InlineData("eXit", "X", true)]
    [InlineData("eXit", "e", false)]
    [InlineData("eXit", "ex", true)]
    [InlineData("ALL", "al", false)]
    [InlineData("ALL", "all", true)]
    public void Capitals_or_a_beginning_that_reaches_the_last_capital_mean_the_option(string option, string typed, bool means) =>
        Assert.Equal(means, new Keyword(option).Matches(typed));

    [Theory]
    [InlineData("L", "Last")]
    [InlineData("la", "LAyer")]
    [InlineData("LAS", "Last")]
    [InlineData("lay", "LAyer")]
    [InlineData("q", null)]
    public void A_short_form_goes_before_a_beginning(string typed, string? found) =>
        Assert.Equal(found, Keyword.Find(Keyword.List("Last", "LAyer"), typed)?.Name);

    [Fact]
    public void A_prompt_shows_instruction_options_and_default()
    {
        Assert.Equal("Specify base point or [Displacement/eXit] <0,0>:", new PointPrompt("Specify base point") { Options = Keyword.List("Displacement", "eXit"), Default = "0,0" }.Text);
        Assert.Equal("Erase source objects? [Yes/No] <No>:", new ChoicePrompt("Erase source objects?") { Options = Keyword.List("Yes", "No"), Default = "No" }.Text);
    }

    [Theory]
    [InlineData("3,4.5", 3, 4.5)]
    [InlineData("#3,4", 3, 4)]
    [InlineData("@3,4", 13, 24)]
    [InlineData("5<90", 0, 5)]
    [InlineData("@5<180", 5, 20)]
    [InlineData("@", 10, 20)]
    public void A_point_is_typed_as_in_a_CAD_program(string typed, double x, double y)
    {
        var point = Assert.IsType<ParsedInput<Point2D>.Value>(new PointPrompt("p").Parse(typed, new Point2D(10, 20))).Result;

        Assert.True(point.IsNear(new Point2D(x, y), 1e-12));
    }

    [Theory]
    [InlineData("3;4")]
    [InlineData("1,2,3")]
    [InlineData("1e999,0")]
    [InlineData("nan,0")]
    [InlineData("#")]
    [InlineData("5<")]
    public void What_is_no_point_is_said_so(string typed) => Assert.IsType<ParsedInput<Point2D>.Invalid>(new PointPrompt("p").Parse(typed, default));
}
