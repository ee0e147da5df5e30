using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Docs;

/// <summary>Links from page to page, and pages named in sources, exist.</summary>
public partial class LinkTests
{
    [Fact]
    public void Every_link_within_the_repository_leads_to_a_file()
    {
        var wrong = from page in SourceFile.Under("", ".md")
                    from Match link in Link().Matches(page.Text)
                    let target = Path.Combine(RepositoryFolder.Root, Path.GetDirectoryName(page.Name) ?? "", link.Groups["target"].Value)
                    where !File.Exists(target) && !Directory.Exists(target)
                    select $"{page.Name}({page.LineOf(link.Index)}): {link.Groups["target"].Value}";
        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_page_that_is_named_exists()
    {
        var wrong = from file in SourceFile.Under("src", ".cs").Concat(SourceFile.Under("", ".md")).Concat(SourceFile.Under("tests", ".cs"))
                    where !file.Name.StartsWith("tests/Engraver.Architecture.Tests/", StringComparison.Ordinal)
                    from Match name in PageName().Matches(file.Text)
                    where !File.Exists(Path.Combine(RepositoryFolder.Root, name.Value))
                    select $"{file.Name}({file.LineOf(name.Index)}): {name.Value}";
        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_decision_record_that_is_named_exists()
    {
        var records = Directory.GetFiles(Path.Combine(RepositoryFolder.Root, "docs", "adr")).Select(path => int.Parse(Path.GetFileName(path)[..4], System.Globalization.CultureInfo.InvariantCulture)).ToList();
        var wrong = from file in SourceFile.Under("", ".cs", ".md")
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
