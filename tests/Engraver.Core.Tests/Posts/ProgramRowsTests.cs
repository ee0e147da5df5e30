using Engraver.Core.Posts;

namespace Engraver.Core.Tests.Posts;

public class ProgramRowsTests
{
    [Theory]
    [InlineData("", "")]
    [InlineData("a", "a")]
    [InlineData("a\n", "a")]
    [InlineData("a\nb", "a|b")]
    [InlineData("a\r\nb\r\n", "a|b")]
    [InlineData("a\rb\r", "a|b")]
    [InlineData("\n\na", "||a")]
    [InlineData("a\r\r\n\nb", "a|||b")]
    public void A_line_ends_with_LF_CR_LF_or_CR(string text, string lines) => Assert.Equal(lines, string.Join('|', All(text)));

    [Fact]
    public void Lines_are_the_same_wherever_the_text_is_cut_to_be_read()
    {
        for (var length = 4090; length < 4100; length++)
        {
            var first = new string('x', length);
            Assert.Equal([first, "second", "", "third"], All($"{first}\r\nsecond\r\n\r\nthird"));
        }
    }

    [Fact]
    public void Lines_have_their_numbers_and_one_that_is_too_long_is_named_by_it()
    {
        var rows = new ProgramRows(new StringReader("a\n" + new string('x', ProgramRows.Longest) + "\n" + new string('x', ProgramRows.Longest + 1)));

        Assert.Equal(("a", 1), (rows.Next(), rows.Number));
        Assert.Equal((ProgramRows.Longest, 2), (rows.Next()!.Length, rows.Number));
        Assert.Contains("line 3 ", Assert.Throws<InvalidDataException>(rows.Next).Message, StringComparison.Ordinal);
    }

    private static List<string> All(string text)
    {
        var (rows, lines) = (new ProgramRows(new StringReader(text)), new List<string>());
        while (rows.Next() is { } line) lines.Add(line);
        return lines;
    }
}
