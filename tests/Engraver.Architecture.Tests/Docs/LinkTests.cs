using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Docs;

/// <summary>Links from page to page, and pages named in sources, exist.</summary>
public partial class LinkTests
{
    /// <summary>README.md and docs/ are pages of the site, whose own tests check their links.</summary>
    [Fact]
    public void Every_link_of_a_page_outside_the_site_leads_to_a_file()
    {
        var pages = SourceFile.Under("", ".md").Where(page => page.Name != "README.md" && !page.Name.StartsWith("docs/", StringComparison.Ordinal)).ToList();
        Assert.NotEmpty(pages);
        var wrong = from page in pages
                    from Match link in Link().Matches(page.Text)
                    let target = Path.Combine(RepositoryFolder.Root, Path.GetDirectoryName(page.Name) ?? "", link.Groups["target"].Value)
                    where !File.Exists(target) && !Directory.Exists(target)
                    select $"{page.Name}({page.LineOf(link.Index)}): {link.Groups["target"].Value}";
        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_picture_is_shown_on_a_page()
    {
        var pictures = Directory.GetFiles(Path.Combine(RepositoryFolder.Root, "docs", "images")).Where(file => Path.GetExtension(file) is ".png" or ".gif").Select(file => Path.GetFileName(file)).ToList();
        var pages = string.Join('\n', SourceFile.Under("docs", ".md").Append(SourceFile.Read(Path.Combine(RepositoryFolder.Root, "README.md"))).Select(page => page.Text));
        Assert.NotEmpty(pictures);
        Assert.DoesNotContain(pictures, picture => !pages.Contains($"images/{picture}", StringComparison.Ordinal));
    }

    [Fact]
    public void Every_page_that_is_named_exists()
    {
        var pages = SourceFile.Under("", ".md");
        var sources = SourceFile.Under("src", ".cs").Concat(SourceFile.Under("tests", ".cs")).Where(file => !file.Name.StartsWith("tests/Engraver.Architecture.Tests/", StringComparison.Ordinal)).ToList();
        Assert.NotEmpty(pages);
        Assert.NotEmpty(sources);
        var wrong = from file in pages.Concat(sources)
                    from Match name in PageName().Matches(file.Text)
                    where !File.Exists(Path.Combine(RepositoryFolder.Root, name.Value))
                    select $"{file.Name}({file.LineOf(name.Index)}): {name.Value}";
        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_decision_record_that_is_named_exists()
    {
        var records = Directory.GetFiles(Path.Combine(RepositoryFolder.Root, "docs", "adr")).Select(path => int.Parse(Path.GetFileName(path)[..4], System.Globalization.CultureInfo.InvariantCulture)).ToList();
        var files = SourceFile.Under("", ".cs", ".md");
        Assert.NotEmpty(records);
        Assert.NotEmpty(files);
        var wrong = from file in files
                    from Match name in Record().Matches(file.Text)
                    where !records.Contains(int.Parse(name.Groups["number"].Value, System.Globalization.CultureInfo.InvariantCulture))
                    select $"{file.Name}({file.LineOf(name.Index)}): {name.Value}";
        Assert.Empty(wrong);
        Assert.Equal(records.Count, records.Distinct().Count());
    }

    [GeneratedRegex(@"\]\((?<target>(?!\w+:)[^)#\s]+)(#[^)]*)?\)")]
    private static partial Regex Link();

    [GeneratedRegex(@"(?<![\w/])docs/[\w/-]+\.md\b")]
    private static partial Regex PageName();

    [GeneratedRegex(@"\bADR (?<number>\d+)\b")]
    private static partial Regex Record();
}
