namespace Engraver.Site;

/// <summary>The repository's part that becomes the site. Paths are relative to the root, with slashes.</summary>
/// <param name="root">The repository.</param>
public sealed class SiteSource(string root)
{
    private readonly List<SitePage> _pages = [];
    private readonly Dictionary<string, SitePage> _byPath = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _files = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _listed = new(StringComparer.Ordinal);

    public IReadOnlyList<SitePage> Pages => _pages;

    /// <summary>Pictures and other files that pages show or link to.</summary>
    public IReadOnlyCollection<string> Files => _files;

    /// <summary>Folders that pages link to, each with its pages.</summary>
    public IEnumerable<(string Folder, IReadOnlyList<SitePage> Pages)> Listings => _listed.Select(folder => (folder, (IReadOnlyList<SitePage>)[.. PagesIn(folder)]));

    public static string ListingOf(string folder) => folder + "/index.html";

    public SitePage? Find(string path) => _byPath.GetValueOrDefault(path);

    public bool HasFile(string path) => File.Exists(Path.Combine(root, path));

    public bool HasFolder(string path) => Directory.Exists(Path.Combine(root, path));

    public IEnumerable<SitePage> PagesIn(string folder) => _pages.Where(page => Path.GetDirectoryName(page.Path)!.Replace('\\', '/') == folder).OrderBy(page => page.Path, StringComparer.Ordinal);

    public void AddFolder(string folder)
    {
        foreach (var path in Directory.GetFiles(Path.Combine(root, folder), "*.md", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            Add(Path.GetRelativePath(root, path).Replace('\\', '/'));
        }
    }

    /// <summary>The page of a Markdown file, which is read when it is new.</summary>
    public SitePage Add(string path)
    {
        if (_byPath.TryGetValue(path, out var known)) return known;
        var page = SitePage.Parse(path, File.ReadAllText(Path.Combine(root, path)));
        _pages.Add(page);
        _byPath.Add(path, page);
        return page;
    }

    public void AddFile(string path) => _files.Add(path);

    public void AddListing(string folder) => _listed.Add(folder);
}
