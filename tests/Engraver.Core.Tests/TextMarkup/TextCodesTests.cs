using Engraver.Core.TextMarkup;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.TextMarkup;

public class TextCodesTests
{
    private const int Many = 200_000;

    [Theory]
    [InlineData("%%c12 %%P0.1 90%%D", "\u230012 \u00B10.1 90\u00B0")]
    [InlineData("100%%% %%065%%233", "100% A\u00E9")]
    [InlineData("%%127 %%128 %%129 %%150", "\u00B0 \u00B1 \u2300 \u2013")]
    [InlineData(@"\U+00D8 8 \M+5B0A1", "\u00D8 8 \u554A")]
    [InlineData(@"\U+D83D\U+DE00", "\U0001F600")]
    [InlineData("a^Ib^ c^Jd^M", "a\tb^c d")]
    [InlineData(@"C:\path {x} ^ ^", @"C:\path {x} ^^")]
    [InlineData("50% %x %%", "50% %x %%")]
    [InlineData("", "")]
    public void Codes_become_characters(string raw, string characters)
    {
        var line = TextCodes.Parse(raw);

        Assert.Equal(characters, string.Concat(line.Runs.Select(run => run.Text)));
        Assert.Empty(line.UnknownCodes);
    }

    [Fact]
    public void Switches_begin_runs_and_equal_neighbours_are_one_run()
    {
        var line = TextCodes.Parse("a%%ub%%oc%%U%%Od%%k%%ke%%kf");

        Assert.Equal([new("a", LineMarks.None), new("b", LineMarks.Underline), new("c", LineMarks.Underline | LineMarks.Overline), new("de", LineMarks.None), new("f", LineMarks.StrikeThrough)], line.Runs);
    }

    [Fact]
    public void Codes_without_a_meaning_are_reported_once()
    {
        var line = TextCodes.Parse(@"%%x %%x %%010 ^A %<\AcVar Date \f ""%<\x>%"">% end");

        Assert.Equal(["%%x", "%%010", "^A", @"%<\AcVar Date \f ""%<\x>%"">%"], line.UnknownCodes);
        Assert.Equal("%%x %%x    end", Assert.Single(line.Runs).Text);
    }

    [Property]
    public void Without_codes_a_text_is_its_characters(string? raw)
    {
        var plain = string.Concat((raw ?? "").Where(one => one >= ' ' && one is not ('%' or '^' or '\\')));

        Assert.Equal(plain, string.Concat(TextCodes.Parse(plain).Runs.Select(run => run.Text)));
    }

    [Property]
    public void Any_string_is_read(string? raw)
    {
        var line = TextCodes.Parse(raw ?? "");

        Assert.All(line.Runs, run => Assert.NotEmpty(run.Text));
        Assert.True(line.Runs.Sum(run => run.Text.Length) <= (raw ?? "").Length);
        for (var at = 1; at < line.Runs.Count; at++) Assert.NotEqual(line.Runs[at - 1].Marks, line.Runs[at].Marks);
    }

    /// <summary>A method that is quadratic would take minutes for one of them.</summary>
    [Theory]
    [InlineData("%%u")]
    [InlineData("a%%ub%%u%%u")]
    [InlineData(@"%<\")]
    [InlineData("%%")]
    [InlineData(@"\U+")]
    [InlineData("^")]
    public void Long_strings_of_codes_are_read(string piece)
    {
        var line = TextCodes.Parse(string.Concat(Enumerable.Repeat(piece, Many)));

        Assert.True(line.UnknownCodes.Count <= 100);
    }
}
