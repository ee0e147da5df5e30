using Engraver.Site;

namespace Engraver.Architecture.Tests.Site;

/// <summary>Faults that end the build of the site.</summary>
public sealed class DeadLinkTests : IDisposable
{
    private readonly DirectoryInfo _root = Directory.CreateTempSubdirectory("engraver-dead-link-");

    public DeadLinkTests()
    {
        Write("README.md", "# Product\n\nSee [the pages](docs/README.md) and [one](docs/one.md#first-part).\n");
        Write("docs/README.md", "# Pages\n\n## Guide\n\n* [One](one.md): the first, before [this](README.md).\n\n## Reference\n\n| Page | |\n|---|---|\n| [Notes](notes) | all |\n| [The second](two.md) | |\n");
        Write("docs/one.md", "# One\n\n## First part\n\nText.\n");
        Write("docs/two.md", "# The second\n\nAn [entry](#the-second), [sources](../src), a [file](../LICENSE), <a href=\"one.md\">one</a>.\n");
        Write("docs/notes/a.md", "# Note A\n\n![](../images/x.png)\n");
        Write("docs/images/x.png", "");
        Write("LICENSE", "MIT");
        Write("src/x.cs", "");
    }

    [Fact]
    public void Links_lead_to_pages_files_and_listings()
    {
        Assert.Empty(Build().Errors);

        Assert.Contains("<a href=\"docs/one.html#first-part\">one</a>", Read("index.html"), StringComparison.Ordinal);
        Assert.Contains("sources, a <a href=\"../LICENSE\">file</a>, <a href=\"one.html\">", Read("docs/two.html"), StringComparison.Ordinal);
        Assert.Contains("<li><a href=\"a.html\">Note A</a></li>", Read("docs/notes/index.html"), StringComparison.Ordinal);
        Assert.True(File.Exists(PathOf("site/docs/images/x.png")) && File.Exists(PathOf("site/LICENSE")));
    }

    [Fact]
    public void A_comment_is_not_in_the_site()
    {
        Write("docs/one.md", "# One\n\n<!-- <img src=\"gone.png\"> -->\n\n## First part\n");

        Assert.Empty(Build().Errors);
        Assert.DoesNotContain("gone.png", Read("docs/one.html"), StringComparison.Ordinal);
    }

    [Fact]
    public void The_first_link_of_an_item_is_in_the_navigation()
    {
        Build();
        var page = Read("docs/notes/a.html");

        Assert.Matches("(?s)<h2>Guide</h2>.*\"../one.html\">One<.*<h2>Reference</h2>.*\"index.html\" aria-current=\"page\">Notes<.*\"../two.html\">The second<", page);
    }

    [Theory]
    [InlineData("[gone](gone.md)", "The link gone.md leads to no file.")]
    [InlineData("[gone](two.md#gone)", "docs/two.md has no heading #gone.")]
    [InlineData("[gone](#gone)", "docs/one.md has no heading #gone.")]
    [InlineData("![gone](images/gone.png)", "The link images/gone.png leads to no file.")]
    [InlineData("[outside](../../outside.md)", "The link ../../outside.md leads to no file.")]
    [InlineData("<img src=\"gone.png\">", "The link gone.png leads to no file.")]
    [InlineData("![elsewhere](https://example.com/x.png)", "The picture https://example.com/x.png is not in the repository. The site uses no external resources.")]
    public void A_dead_link_is_an_error_with_its_file_and_line(string link, string expected)
    {
        Write("docs/one.md", $"# One\n\n## First part\n\nText with {link}.\n");

        Assert.Equal([$"docs/one.md(5): {expected}"], Build().Errors);
        Assert.False(Directory.Exists(PathOf("site")));
    }

    [Fact]
    public void A_folder_with_other_files_is_refused_and_an_earlier_site_is_replaced()
    {
        Write("site/thesis.txt", "three years");

        Assert.Equal([PathOf("site") + " contains files that are not a site of this program. Choose an empty folder."], Build().Errors);
        Assert.Equal("three years", Read("thesis.txt"));

        File.Delete(PathOf("site/thesis.txt"));
        Assert.Empty(Build().Errors);
        Write("site/old.html", "");
        Assert.Empty(Build().Errors);
        Assert.False(File.Exists(PathOf("site/old.html")));
    }

    [Fact]
    public void A_missing_index_page_is_an_error()
    {
        Write("README.md", "# Product\n");
        File.Delete(PathOf("docs/README.md"));

        Assert.StartsWith("docs/README.md(1): ", Assert.Single(Build().Errors), StringComparison.Ordinal);
    }

    public void Dispose() => _root.Delete(recursive: true);

    private BuiltSite Build() => SiteBuilder.Build(_root.FullName, PathOf("site"));

    private string PathOf(string path) => Path.Combine(_root.FullName, path);

    private string Read(string address) => File.ReadAllText(PathOf("site/" + address));

    private void Write(string path, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(PathOf(path))!);
        File.WriteAllText(PathOf(path), text);
    }
}
