using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Citations;

/// <summary>A fact in the code names the page that states it; these tests look up every such name. The cited pages are in docs/reference and docs.</summary>
public class CitationTests
{
    private static readonly string[] s_text = [".cs", ".md", ".axaml", ".csproj", ".props", ".targets"];

    [Fact]
    public void Every_citation_leads_to_a_heading()
    {
        var wrong = new List<string>();
        var count = 0;
        foreach (var file in Sources())
        {
            foreach (var (position, citation) in CitationReader.Read(file.Text, Prose(file)))
            {
                count++;
                if (Unresolved(citation) is { } why) wrong.Add($"{file.Name}({file.LineOf(position)}): {why}");
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count} of {count} citations lead nowhere:\n" + string.Join('\n', wrong));
        Assert.True(count > 300, $"Only {count} citations were found: the reader of citations no longer knows the forms in use.");
    }

    [Theory]
    [InlineData("(galil-dmc.md B.3)", "B.3")]
    [InlineData("(galil-dmc.md A.1, A.3 format commands, C).", "A.1 A.3 C")]
    [InlineData("(galil-dmc.md B.1 to B.8).", "B.1 B.8")]
    [InlineData("(galil-dmc.md E, Array; A.8 codes 80 to 82)", "E:Array A.8:80")]
    [InlineData("(galil-dmc.md J 16). Null", "J.16")]
    [InlineData("galil-dmc.md F.4: CB, STS, ST AB", "F.4")]
    [InlineData("galil-dmc.md\n    /// EX11, EX12, F.3)", "EX11 EX12 F.3")]
    [InlineData("hmi-conventions.md section 4.</remarks>", "4")]
    [InlineData("galil-dmc.md) that we can vary", "")]
    public void The_forms_of_a_citation_are_understood(string text, string expected)
    {
        var marks = CitationReader.Read(text, "").Select(found => found.Citation).Select(one => one.Details.Count == 0 ? one.Mark : $"{one.Mark}:{string.Join('+', one.Details)}");
        Assert.Equal(expected, string.Join(' ', marks));
    }

    [Theory]
    [InlineData("galil-dmc.md B.3", true)]
    [InlineData("galil-dmc.md B.33", false)]
    [InlineData("galil-dmc.md E, Poetry", false)]
    [InlineData("no-such-page: sections A.99", false)]
    [InlineData("paper 999", false)]
    public void A_citation_that_leads_nowhere_is_noticed(string text, bool good) =>
        Assert.Equal(good, CitationReader.Read(text, text).All(found => Unresolved(found.Citation) is null));

    private static IEnumerable<SourceFile> Sources() =>
        new[] { "src", "tests", "samples", "docs" }.SelectMany(folder => SourceFile.Under(folder, s_text))
            .Append(SourceFile.Read(Path.Combine(TestKit.RepositoryFolder.Root, "README.md")))
            .Where(file => !file.Name.StartsWith("docs/reference/", StringComparison.Ordinal) && !file.Name.StartsWith("tests/Engraver.Architecture.Tests/", StringComparison.Ordinal));

    /// <summary>Bare marks are searched in comments. The software platform is excluded, because its marks are those of other standards (SVG,
    /// TrueType).</summary>
    private static string Prose(SourceFile file) =>
        file.Name.Contains("/Engraver.SoftwarePlatform", StringComparison.Ordinal) ? "" : file.Name.EndsWith(".cs", StringComparison.Ordinal) ? CSharpText.Parse(file.Text).Comments : file.Text;

    /// <summary>The fault of a citation; null when it refers to an existing section.</summary>
    private static string? Unresolved(Citation citation)
    {
        if (ReferenceBook.Open(citation.Page) is not { } page) return $"{citation.Page} stands neither in docs/reference nor in docs.";
        if (citation.Mark.Length > 0 && page.Section(citation.Mark) is null) return $"{citation.Page} has no section {citation.Mark}.";
        var section = citation.Mark.Length > 0 ? page.Section(citation.Mark)! : page.Text;
        return citation.Details.FirstOrDefault(word => !section.Contains(word, StringComparison.OrdinalIgnoreCase)) is { } lost ? $"'{lost}' does not occur in {citation.Page} {citation.Mark}." : null;
    }
}
