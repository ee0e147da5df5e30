using System.Globalization;
using System.Text.RegularExpressions;
using Markdig.Helpers;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Engraver.Site;

/// <summary>Turns the links of Markdown files into links of the site, and finds dead ones.</summary>
internal static partial class LinkResolver
{
    /// <summary>Rewrites the links of a page. Linked pages, pictures, files and folders are added to the source.</summary>
    public static void Resolve(SiteSource source, SitePage page, List<string> errors)
    {
        foreach (var link in page.Document.Descendants<LinkInline>().ToList())
        {
            if (Target(source, page, link.Url ?? "", link.IsImage, link.Line, errors) is { } address) link.Url = address;
            else Unlink(link);
        }

        foreach (var comment in page.Document.Descendants<HtmlBlock>().Where(html => html.Type == HtmlBlockType.Comment).ToList()) comment.Parent!.Remove(comment);

        foreach (var html in page.Document.Descendants<HtmlBlock>())
        {
            for (var i = 0; i < html.Lines.Count; i++) html.Lines.Lines[i].Slice = new StringSlice(Rewritten(source, page, html.Lines.Lines[i].Slice.ToString(), html.Line + i, errors));
        }

        foreach (var html in page.Document.Descendants<HtmlInline>()) html.Tag = Rewritten(source, page, html.Tag, html.Line, errors);
    }

    /// <summary>Every link to a heading, now that all pages are known.</summary>
    public static void CheckAnchors(SiteSource source, List<string> errors)
    {
        var pages = source.Pages.ToDictionary(page => page.Address, StringComparer.Ordinal);
        foreach (var page in source.Pages)
        {
            foreach (var link in page.Document.Descendants<LinkInline>())
            {
                if (link.Url is not { } url || url.IndexOf('#') is not (>= 0 and var at) || IsElsewhere(url)) continue;
                var target = at == 0 ? page : pages.GetValueOrDefault(Combined(page.Address, url[..at]) ?? "");
                if (target is not null && !target.HasAnchor(Uri.UnescapeDataString(url[(at + 1)..]))) errors.Add(At(page, link.Line, $"{target.Path} has no heading #{url[(at + 1)..]}."));
            }
        }
    }

    /// <summary>The path that a relative link leads to; null when it leaves the repository.</summary>
    internal static string? Combined(string from, string link)
    {
        var parts = new List<string>(from.Split('/')[..^1]);
        foreach (var part in link.Split('/'))
        {
            if (part is "" or ".") continue;
            if (part != "..") parts.Add(part);
            else if (parts.Count == 0) return null;
            else parts.RemoveAt(parts.Count - 1);
        }

        return string.Join('/', parts);
    }

    /// <summary>The relative link from one address of the site to another.</summary>
    internal static string Relative(string from, string to)
    {
        var (here, there) = (from.Split('/')[..^1], to.Split('/'));
        var common = 0;
        while (common < here.Length && common < there.Length - 1 && here[common] == there[common]) common++;
        return string.Concat(Enumerable.Repeat("../", here.Length - common)) + string.Join('/', there[common..]);
    }

    internal static string At(SitePage page, int line, string what) => string.Create(CultureInfo.InvariantCulture, $"{page.Path}({line + 1}): {what}");

    /// <returns>Null for a folder of sources, which is not part of the site.</returns>
    private static string? Target(SiteSource source, SitePage page, string url, bool isImage, int line, List<string> errors)
    {
        if (IsElsewhere(url))
        {
            if (isImage) errors.Add(At(page, line, $"The picture {url} is not in the repository. The site uses no external resources."));
            return url;
        }

        var (target, anchor) = url.IndexOf('#') is >= 0 and var at ? (url[..at], url[at..]) : (url, "");
        if (target.Length == 0) return url;
        var path = Combined(page.Path, Uri.UnescapeDataString(target));
        if (path is not null && AddressOf(source, path) is { } address) return Relative(page.Address, address) + anchor;
        if (path is null || !source.HasFolder(path)) errors.Add(At(page, line, $"The link {url} leads to no file."));
        return null;
    }

    private static string? AddressOf(SiteSource source, string path)
    {
        if (source.HasFile(path))
        {
            if (path.EndsWith(".md", StringComparison.OrdinalIgnoreCase)) return source.Add(path).Address;
            source.AddFile(path);
            return path;
        }

        if (!source.HasFolder(path)) return null;
        var readme = path.Length == 0 ? "README.md" : path + "/README.md";
        if (source.HasFile(readme)) return source.Add(readme).Address;
        if (!source.PagesIn(path).Any()) return null;
        source.AddListing(path);
        return SiteSource.ListingOf(path);
    }

    private static string Rewritten(SiteSource source, SitePage page, string html, int line, List<string> errors) =>
        Reference().Replace(html, found => found.Groups[1].Value + (Target(source, page, found.Groups[3].Value, found.Groups[2].Value != "href", line, errors) ?? "#") + '"');

    /// <summary>Leaves the words of a link alone.</summary>
    private static void Unlink(LinkInline link)
    {
        while (link.FirstChild is { } child)
        {
            child.Remove();
            link.InsertBefore(child);
        }

        link.Remove();
    }

    private static bool IsElsewhere(string url) => Scheme().IsMatch(url);

    [GeneratedRegex(@"^([A-Za-z][A-Za-z0-9+.-]*:|//)")]
    private static partial Regex Scheme();

    [GeneratedRegex(@"(\b(src|href|srcset)="")([^""]*)""")]
    private static partial Regex Reference();
}
