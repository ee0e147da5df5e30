using System.Net;
using System.Text.Json;
using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Site;

/// <summary>The static site of README.md and docs/.</summary>
public partial class SiteTests(SiteFixture site) : IClassFixture<SiteFixture>
{
    [Fact]
    public void No_link_of_the_documentation_is_dead() => Assert.True(site.Built.Errors.Count == 0, string.Join('\n', site.Built.Errors));

    [Fact]
    public void Every_page_of_the_documentation_is_in_the_site()
    {
        var sources = Directory.GetFiles(Path.Combine(RepositoryFolder.Root, "docs"), "*.md", SearchOption.AllDirectories).Select(path => Path.GetRelativePath(RepositoryFolder.Root, path).Replace('\\', '/')).Append("README.md");

        Assert.Empty(sources.Except(site.Built.Pages.Select(page => page.Path)));
        Assert.Empty(site.Built.Pages.Select(page => page.Address).Except(site.Pages.Select(page => page.Address)));
    }

    /// <summary>Checks only the HTML, so that the parts added by the site are checked as well.</summary>
    [Fact]
    public void Every_link_of_the_site_leads_to_a_file_of_the_site_and_to_its_anchor()
    {
        var pages = site.Pages.ToDictionary(page => page.Address, page => Id().Matches(page.Html).Select(id => WebUtility.HtmlDecode(id.Groups[1].Value)).ToHashSet());
        var dead = from page in site.Pages
                   from Match link in Reference().Matches(page.Html)
                   let url = WebUtility.HtmlDecode(link.Groups[1].Value)
                   where !IsElsewhere(url)
                   let parts = url.Split('#')
                   let path = parts[0].Length == 0 ? page.Address : Path.GetRelativePath("/", Path.GetFullPath(Path.Combine("/", Path.GetDirectoryName(page.Address)!, Uri.UnescapeDataString(parts[0])))).Replace('\\', '/')
                   where !File.Exists(Path.Combine(site.Folder, path)) || (parts.Length > 1 && !pages[path].Contains(Uri.UnescapeDataString(parts[1])))
                   select $"{page.Address}: {url}";

        Assert.Empty(dead);
        Assert.NotEmpty(pages);
    }

    [Fact]
    public void The_site_loads_nothing_from_elsewhere()
    {
        Assert.Empty(site.Pages.SelectMany(page => Resource().Matches(page.Html).Where(resource => IsElsewhere(resource.Groups[1].Value)).Select(resource => $"{page.Address}: {resource.Value}")));
        Assert.DoesNotMatch(@"url\(|@import", File.ReadAllText(Path.Combine(site.Folder, "assets", "site.css")));
        Assert.DoesNotMatch(@"https?:|fetch\(|XMLHttpRequest", File.ReadAllText(Path.Combine(site.Folder, "assets", "site.js")));
    }

    [Fact]
    public void The_search_finds_the_words_of_each_page()
    {
        var script = File.ReadAllText(Path.Combine(site.Folder, "assets", "search.js"));
        var index = JsonDocument.Parse(script["var searchIndex = ".Length..script.LastIndexOf(';')]).RootElement.EnumerateArray().ToDictionary(page => page[1].GetString()!);

        Assert.All(site.Built.Pages, page =>
        {
            var entry = index[page.Address];
            var text = string.Join(' ', entry[2].EnumerateArray().Select(section => $"{section[1]} {section[2]}"));
            var word = Word().Matches(File.ReadAllText(Path.Combine(RepositoryFolder.Root, page.Path))).Select(found => found.Value).MaxBy(found => found.Length)!;
            Assert.Equal(page.Title, entry[0].GetString());
            Assert.Contains(word, text, StringComparison.Ordinal);
        });
    }

    [Fact]
    public void The_navigation_is_that_of_the_index_page()
    {
        var index = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, "docs", "README.md"));
        var groups = index.Where(line => line.StartsWith("## ", StringComparison.Ordinal)).Select(line => line[3..].Trim());
        var shown = Group().Matches(site.Pages.Single(page => page.Address == "index.html").Html).Select(group => WebUtility.HtmlDecode(group.Groups[1].Value)).ToList();

        Assert.Subset(groups.ToHashSet(), shown.ToHashSet());
        Assert.All(["Guide", "Reference", "Explanation", "Library"], group => Assert.Contains(group, shown));
    }

    private static bool IsElsewhere(string url) => Regex.IsMatch(url, "^([a-z]+:|//)");

    [GeneratedRegex(@"<[a-z][^>]* id=""([^""]+)""")]
    private static partial Regex Id();

    [GeneratedRegex(@"<[a-z][^>]* (?:href|src)=""([^""]*)""")]
    private static partial Regex Reference();

    [GeneratedRegex(@"<(?:img|script|link|source|iframe|video)[^>]* (?:href|src|srcset)=""([^""]*)""")]
    private static partial Regex Resource();

    [GeneratedRegex(@"(?<=^[A-Z][^`<>\[\]()*_|#&\\/]*)\b[A-Za-z]{4,}\b", RegexOptions.Multiline)]
    private static partial Regex Word();

    [GeneratedRegex("<h2>([^<]*)</h2>")]
    private static partial Regex Group();
}
