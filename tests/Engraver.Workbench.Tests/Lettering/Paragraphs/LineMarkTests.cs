using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>Underline, overline and strike-through.</summary>
public class LineMarkTests
{
    [Fact]
    public void A_mark_is_one_line_over_words_blanks_tabs_and_colours()
    {
        var rule = Assert.Single(Of(@"H\LHO {\C1;HO}^IH\lH").Rules);
        Assert.Equal((Advance("H"), -12.0, 80.0 + Advance("H"), -12.0), (rule.From.X, rule.From.Y, rule.To.X, rule.To.Y));
    }

    [Fact]
    public void Each_mark_has_its_height()
    {
        Assert.Equal([-12.0, 2.0, -5.0], Of(@"\L\O\KH").Rules.Select(rule => Math.Round(rule.From.Y, 9)));
        Assert.Equal([-11.0, 2.0], Of(@"{\H5;\LH}{\OH}").Rules.Select(rule => Math.Round(rule.From.Y, 9)));
    }

    [Fact]
    public void Blanks_at_the_end_of_a_paragraph_are_marked_those_before_a_wrap_are_not()
    {
        Assert.Equal(Advance("HO   "), Assert.Single(Of(@"\LHO   ").Rules).To.X, 9);
        var wrapped = Of(@"\LHO   HO", new() { ReferenceWidth = 25.0 }).Rules;
        Assert.Equal([Advance("HO"), Advance("HO")], wrapped.Select(rule => rule.To.X), (expected, actual) => Math.Abs(expected - actual) < 1e-9);
    }

    [Fact]
    public void A_stack_is_marked_below_and_above_both_texts()
    {
        var rules = Of(@"\L\O\S1^2;").Rules;
        Assert.Equal(2, rules.Count);
        Assert.Equal(14.0 + 14.0, rules[1].From.Y - rules[0].From.Y, 9);
    }

    [Fact]
    public void Marks_follow_the_slant_of_their_letters()
    {
        var rule = Assert.Single(Of(@"\Q45;\OH").Rules);
        Assert.Equal((12.0, 12.0 + Advance("H")), (Math.Round(rule.From.X, 9), Math.Round(rule.To.X, 12)), Pairs);
    }

    [Fact]
    public void A_mark_grows_with_a_line_that_is_spread()
    {
        var rules = Of(@"\pqd;\LHO I", new() { ReferenceWidth = Inked("HO I") + 6.0 }).Rules;
        Assert.Equal((0.0, Advance("HO I") + 6.0), (rules[0].From.X, rules[^1].To.X), Pairs);
        Assert.Single(rules);
    }

    private static bool Pairs((double First, double Second) expected, (double First, double Second) actual) =>
        Math.Abs(expected.First - actual.First) < 1e-9 && Math.Abs(expected.Second - actual.Second) < 1e-9;
}
