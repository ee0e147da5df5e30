using Markdig.Extensions.Tables;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Engraver.Site;

/// <summary>A group of pages that docs/README.md lists under one heading.</summary>
public sealed record NavigationGroup(string Title, IReadOnlyList<NavigationEntry> Entries);

/// <summary>A page as docs/README.md lists it.</summary>
/// <param name="Address">In the site.</param>
public sealed record NavigationEntry(string Title, string Address);

/// <summary>The groups of docs/README.md: each heading of the second level with the first link of every list item and table row below it.</summary>
public sealed record Navigation(IReadOnlyList<NavigationGroup> Groups)
{
    private const string Index = "docs/README.md";

    /// <summary>All entries in order, for the next and the previous page.</summary>
    public IReadOnlyList<NavigationEntry> Entries { get; } = [.. Groups.SelectMany(group => group.Entries)];

    internal static Navigation Read(SiteSource source, List<string> errors)
    {
        if (source.Find(Index) is not { } index)
        {
            errors.Add($"{Index}(1): The page is missing. The navigation of the site is read from it.");
            return new Navigation([]);
        }

        var groups = new List<NavigationGroup>();
        var seen = new HashSet<string>(StringComparer.Ordinal) { "index.html" };
        foreach (var heading in index.Document.OfType<HeadingBlock>().Where(heading => heading.Level == 2))
        {
            var below = index.Document.SkipWhile(block => block != heading).Skip(1).TakeWhile(block => block is not HeadingBlock { Level: <= 2 });
            var entries = below.SelectMany(Links).Select(link => new NavigationEntry(SitePage.TextOf(link), AddressOf(index, link))).Where(entry => entry.Address.EndsWith(".html", StringComparison.Ordinal) && seen.Add(entry.Address)).ToList();
            if (entries.Count > 0) groups.Add(new NavigationGroup(SitePage.TextOf(heading.Inline), entries));
        }

        if (groups.Count == 0) errors.Add($"{Index}(1): No heading of the second level has a list of pages. The navigation of the site is read from them.");
        return new Navigation(groups);
    }

    /// <summary>The entry that is marked on a page: its own, or the listing of its folder.</summary>
    public NavigationEntry? Current(string address)
    {
        var listing = LinkResolver.Combined(address, "index.html");
        return Entries.FirstOrDefault(entry => entry.Address == address) ?? Entries.FirstOrDefault(entry => entry.Address == listing && listing.Count(c => c == '/') > 1);
    }

    private static IEnumerable<LinkInline> Links(Block block) => block switch
    {
        ListItemBlock or TableRow => block.Descendants().OfType<LinkInline>().Take(1),
        ContainerBlock container => container.SelectMany(Links),
        _ => [],
    };

    private static string AddressOf(SitePage index, LinkInline link)
    {
        var page = (link.Url ?? "").Split('#')[0];
        return LinkResolver.Combined(index.Address, page) ?? "";
    }
}
