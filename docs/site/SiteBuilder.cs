namespace Engraver.Site;

/// <summary>A built site.</summary>
/// <param name="Pages">In the order in which they were found.</param>
/// <param name="Errors">Each as <c>file(line): what is wrong</c>.</param>
public sealed record BuiltSite(IReadOnlyList<SitePage> Pages, IReadOnlyList<string> Errors);

/// <summary>Makes a static site of README.md, docs/ and the Markdown pages that they link to.</summary>
public static class SiteBuilder
{
    private static readonly string[] s_assets = ["site.css", "site.js", "icon.png"];

    private const string SearchScript = "assets/search.js";

    /// <summary>Reads the pages, checks every link and writes the site. Nothing is written when a link is dead.</summary>
    /// <param name="root">The repository.</param>
    /// <param name="output">An earlier site there is replaced. A folder with other files is an error, and nothing in it is changed.</param>
    /// <exception cref="IOException">A page cannot be read, or the folder cannot be written.</exception>
    public static BuiltSite Build(string root, string output)
    {
        if (!MayReplace(output)) return new BuiltSite([], [$"{output} contains files that are not a site of this program. Choose an empty folder."]);
        var source = new SiteSource(root);
        source.AddFolder("docs");
        source.Add("README.md");
        var errors = new List<string>();
        for (var i = 0; i < source.Pages.Count; i++) LinkResolver.Resolve(source, source.Pages[i], errors); // adds the pages that are linked
        LinkResolver.CheckAnchors(source, errors);
        var navigation = Navigation.Read(source, errors);
        if (errors.Count > 0) return new BuiltSite(source.Pages, errors);

        if (Directory.Exists(output)) Directory.Delete(output, recursive: true);
        foreach (var page in source.Pages) Write(output, page.Address, PageTemplate.Render(page, navigation));
        foreach (var (folder, pages) in source.Listings) Write(output, SiteSource.ListingOf(folder), PageTemplate.RenderListing(folder, pages, navigation));
        foreach (var file in source.Files) Copy(Path.Combine(root, file), Path.Combine(output, file));
        Write(output, SearchScript, SearchIndex.Render(source.Pages));
        foreach (var asset in s_assets) Unpack(asset, Path.Combine(output, "assets", asset));
        return new BuiltSite(source.Pages, errors);
    }

    private static bool MayReplace(string output) =>
        File.Exists(Path.Combine(output, SearchScript)) || !Directory.Exists(output) || !Directory.EnumerateFileSystemEntries(output).Any();

    private static void Write(string output, string address, string text)
    {
        var path = Path.Combine(output, address);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, text);
    }

    private static void Copy(string from, string to)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(to)!);
        File.Copy(from, to);
    }

    private static void Unpack(string asset, string path)
    {
        using var from = typeof(SiteBuilder).Assembly.GetManifestResourceStream(asset)!;
        using var to = File.Create(path);
        from.CopyTo(to);
    }
}
