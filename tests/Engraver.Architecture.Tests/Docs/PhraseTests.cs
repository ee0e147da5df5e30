using System.Text.RegularExpressions;
using System.Xml.Linq;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Docs;

/// <summary>Texts, pages and comments use none of the phrases of CONTRIBUTING.md, and lines of prose are at most 160 characters.</summary>
public partial class PhraseTests
{
    private const int LongestLine = 160;
    private const string Example = "# Page\n\n" + UnusedPhrases.Heading + "\n\n| Not | But | Allowed |\n|---|---|---|\n| goes on, gone on | continues | goes on and off |\n| of ours | internal | |\n\n## Next\n\nText.";

    [Fact]
    public void No_text_has_a_phrase_that_is_not_used()
    {
        var phrases = UnusedPhrases.Read();
        Assert.InRange(phrases.Count, 30, 1000);

        var wrong = from file in SourceFile.Under("src", ".resx").Concat(SourceFile.Under("tools", ".resx"))
                    from data in XDocument.Parse(file.Text).Root!.Elements("data")
                    from found in phrases.Find(Code().Replace(data.Element("value")!.Value, ""))
                    select $"{file.Name}: {data.Attribute("name")!.Value}: '{found.Words}', write: {found.Instead}";

        AssertNone(wrong);
    }

    [Fact]
    public void No_page_has_a_phrase_that_is_not_used()
    {
        var phrases = UnusedPhrases.Read();
        var pages = Pages().ToList();
        Assert.NotEmpty(pages);
        var wrong = from page in pages
                    from found in phrases.Find(Prose(page.Text))
                    select $"{page.Name}({page.LineOf(found.Index)}): '{found.Words}', write: {found.Instead}";

        AssertNone(wrong);
    }

    [Fact]
    public void No_comment_has_a_phrase_that_is_not_used()
    {
        var phrases = UnusedPhrases.Read();
        var sources = SourceFile.Under("", ".cs").ToList();
        Assert.NotEmpty(sources);
        var wrong = from file in sources
                    from found in phrases.Find(CommentWords(file.Text))
                    select $"{file.Name}({file.LineOf(found.Index)}): '{found.Words}', write: {found.Instead}";

        AssertNone(wrong);
    }

    [Fact]
    public void No_line_of_prose_is_too_long()
    {
        var pages = Pages().ToList();
        Assert.NotEmpty(pages);
        var wrong = from page in pages
                    from line in Prose(page.Text).Split('\n').Index()
                    where line.Item.TrimEnd().Length > LongestLine && !line.Item.StartsWith('|')
                    select $"{page.Name}({line.Index + 1}): {line.Item.TrimEnd().Length} characters";

        AssertNone(wrong);
    }

    [Fact]
    public void No_line_of_a_comment_is_too_long()
    {
        var sources = SourceFile.Under("", ".cs").ToList();
        Assert.NotEmpty(sources);
        var wrong = from file in sources
                    from line in file.Text.Split('\n').Index()
                    where line.Item.TrimEnd().Length > LongestLine && line.Item.TrimStart().StartsWith("//", StringComparison.Ordinal)
                    select $"{file.Name}({line.Index + 1}): {line.Item.TrimEnd().Length} characters";

        AssertNone(wrong);
    }

    [Theory]
    [InlineData("The job goes on.", "goes on")]
    [InlineData("It was Gone\non with.", "Gone\non")]
    [InlineData("a bug of ours", "of ours")]
    public void A_phrase_is_noticed(string text, string words) => Assert.Equal([words], UnusedPhrases.Parse(Example).Find(text).Select(found => found.Words));

    [Theory]
    [InlineData("The lamp goes on and off.")]
    [InlineData("The cargoes on board.")]
    [InlineData("of ours-like")]
    public void What_is_allowed_or_another_word_is_not(string text) => Assert.Empty(UnusedPhrases.Parse(Example).Find(text));

    [Theory]
    [InlineData("Call(); // it goes\n    // on", "goes\n       on")]
    [InlineData("/// <summary>It <c>goes on</c> <see cref=\"Of.Ours\"/> of ours.</summary>", "of ours")]
    [InlineData("var text = \"goes on\";", null)]
    public void Phrases_are_found_in_comments_only(string code, string? words) =>
        Assert.Equal(words is null ? [] : [words], UnusedPhrases.Parse(Example).Find(CommentWords(code)).Select(found => found.Words));

    [Fact]
    public void The_table_itself_is_not_searched() => Assert.Empty(UnusedPhrases.Parse(Example).Find(UnusedPhrases.WithoutTable(Example)));

    /// <summary>Every page for readers except docs/reference, which quotes the sources that the code cites.</summary>
    private static IEnumerable<SourceFile> Pages() => SourceFile.Under("", ".md").Where(page => !page.Name.StartsWith("docs/reference/", StringComparison.Ordinal) && !page.Name.StartsWith("tests/", StringComparison.Ordinal));

    /// <summary>The page without code and without the addresses of links; every other character keeps its position.</summary>
    private static string Prose(string page) => Code().Replace(UnusedPhrases.WithoutTable(page), code => NotLineEnd().Replace(code.Value, " "));

    /// <summary>The words of the comments without marks, tags and code; every other character keeps its position, so that a phrase may continue in the next
    /// line.</summary>
    private static string CommentWords(string source) => CommentMarks().Replace(CSharpText.Parse(source).Comments, mark => NotLineEnd().Replace(mark.Value, " "));

    private static void AssertNone(IEnumerable<string> wrong)
    {
        var all = wrong.ToList();
        Assert.True(all.Count == 0, $"{all.Count} (the phrases and what to write instead: CONTRIBUTING.md):\n" + string.Join('\n', all.Take(400)));
    }

    [GeneratedRegex(@"^```.*?^```|`[^`\n]*`|\]\([^)\n]*\)", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Code();

    [GeneratedRegex(@"^[^\S\n]*//[/]?|(?<=[^\S\n])//|<c>.*?</c>|<[^>]*>", RegexOptions.Multiline)]
    private static partial Regex CommentMarks();

    [GeneratedRegex(@"[^\n]")]
    private static partial Regex NotLineEnd();
}
