using System.Globalization;
using System.Net;
using System.Text;
using Markdig;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Engraver.Site;

/// <summary>Pages as HTML.</summary>
internal static class PageTemplate
{
    private const string Product = "CncEngraver";

    public static string Render(SitePage page, Navigation navigation)
    {
        Decorate(page.Document);
        var body = page.Document.ToHtml(SitePage.Pipeline).Replace("<table>", "<div class=\"table\"><table>", StringComparison.Ordinal).Replace("</table>", "</table></div>", StringComparison.Ordinal);
        var description = page.Document.Descendants<ParagraphBlock>().Select(paragraph => SitePage.TextOf(paragraph.Inline)).FirstOrDefault(text => text.Length > 0) ?? page.Title;
        return Frame(page.Address, page.Title, description, body, Contents(page), navigation);
    }

    /// <summary>A page that lists the pages of a folder.</summary>
    public static string RenderListing(string folder, IReadOnlyList<SitePage> pages, Navigation navigation)
    {
        var address = SiteSource.ListingOf(folder);
        var title = navigation.Entries.FirstOrDefault(entry => entry.Address == address)?.Title ?? folder;
        var body = new StringBuilder("<h1>" + Escaped(title) + "</h1>\n<ul>\n");
        foreach (var page in pages) body.Append(CultureInfo.InvariantCulture, $"<li><a href=\"{LinkResolver.Relative(address, page.Address)}\">{Escaped(page.Title)}</a></li>\n");
        return Frame(address, title, title, body.Append("</ul>\n").ToString(), "", navigation);
    }

    /// <summary>An anchor at every heading; pictures open in full size.</summary>
    private static void Decorate(MarkdownDocument document)
    {
        foreach (var heading in document.Descendants<HeadingBlock>().Where(heading => heading.Level > 1))
        {
            heading.Inline?.AppendChild(new HtmlInline($"<a class=\"anchor\" href=\"#{heading.GetAttributes().Id}\" aria-label=\"Link to this heading\">#</a>"));
        }

        foreach (var picture in document.Descendants<LinkInline>().Where(link => link.IsImage).ToList())
        {
            picture.GetAttributes().AddProperty("loading", "lazy");
            if (picture.Parent is LinkInline) continue;
            var frame = new LinkInline { Url = picture.Url };
            frame.GetAttributes().AddClass("picture");
            picture.ReplaceBy(frame);
            frame.AppendChild(picture);
        }
    }

    private static string Frame(string address, string title, string description, string body, string contents, Navigation navigation)
    {
        var root = LinkResolver.Relative(address, "");
        var heading = title == Product ? title : $"{title} - {Product}";
        return $"""
            <!DOCTYPE html>
            <html lang="en" data-root="{root}">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>{Escaped(heading)}</title>
            <meta name="description" content="{Escaped(description)}">
            <link rel="icon" href="{root}assets/icon.png">
            <link rel="stylesheet" href="{root}assets/site.css">
            <script src="{root}assets/site.js"></script>
            </head>
            <body>
            <a class="skip" href="#content">Skip to the content</a>
            <header class="top">
            <button class="menu" type="button" aria-label="Pages" aria-controls="pages" aria-expanded="false"><svg viewBox="0 0 20 20"><path d="M3 5.5h14M3 10h14M3 14.5h14"/></svg></button>
            <a class="brand" href="{root}index.html"><img src="{root}assets/icon.png" alt="" width="24" height="24">{Product}</a>
            <div class="search" role="search"><input type="search" placeholder="Search" aria-label="Search the documentation" autocomplete="off" spellcheck="false"><kbd>/</kbd><div class="results" hidden></div></div>
            <button class="theme" type="button" aria-label="Switch between light and dark"><svg viewBox="0 0 20 20"><circle cx="10" cy="10" r="7"/><path class="half" d="M10 3a7 7 0 0 1 0 14z"/></svg></button>
            </header>
            <div class="frame">
            <nav id="pages" class="pages" aria-label="Pages">
            {Pages(address, navigation)}</nav>
            <main id="content">
            {contents}<article>
            {body}</article>
            {Neighbours(address, navigation)}</main>
            </div>
            </body>
            </html>

            """;
    }

    private static string Pages(string address, Navigation navigation)
    {
        var current = navigation.Current(address)?.Address ?? address;
        var list = new StringBuilder("<ul>\n").Append(Entry(new NavigationEntry("Overview", "index.html"), address, current)).Append(Entry(new NavigationEntry("All documentation", "docs/index.html"), address, current)).Append("</ul>\n");
        foreach (var group in navigation.Groups)
        {
            list.Append(CultureInfo.InvariantCulture, $"<h2>{Escaped(group.Title)}</h2>\n<ul>\n");
            foreach (var entry in group.Entries) list.Append(Entry(entry, address, current));
            list.Append("</ul>\n");
        }

        return list.ToString();
    }

    private static string Entry(NavigationEntry entry, string address, string current) =>
        $"<li><a href=\"{LinkResolver.Relative(address, entry.Address)}\"{(entry.Address == current ? " aria-current=\"page\"" : "")}>{Escaped(entry.Title)}</a></li>\n";

    private static string Contents(SitePage page)
    {
        var headings = page.Headings.Where(heading => heading.Level is 2 or 3).ToList();
        if (headings.Count < 2) return "";
        var list = new StringBuilder("<details class=\"contents\" open><summary>On this page</summary><ul>\n");
        foreach (var heading in headings) list.Append(CultureInfo.InvariantCulture, $"<li class=\"level{heading.Level}\"><a href=\"#{heading.Id}\">{Escaped(heading.Text)}</a></li>\n");
        return list.Append("</ul></details>\n").ToString();
    }

    private static string Neighbours(string address, Navigation navigation)
    {
        var entries = navigation.Entries;
        var at = entries.TakeWhile(entry => entry.Address != address).Count();
        if (at == entries.Count) return "";
        string Link(int index, string kind, string label) => index >= 0 && index < entries.Count
            ? $"<a class=\"{kind}\" rel=\"{kind}\" href=\"{LinkResolver.Relative(address, entries[index].Address)}\"><small>{label}</small>{Escaped(entries[index].Title)}</a>\n"
            : "";
        return $"<footer class=\"neighbours\">\n{Link(at - 1, "prev", "Previous")}{Link(at + 1, "next", "Next")}</footer>\n";
    }

    private static string Escaped(string text) => WebUtility.HtmlEncode(text);
}
