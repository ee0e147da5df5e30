using Engraver.Site;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Site;

/// <summary>The site of this repository, built once.</summary>
public sealed class SiteFixture : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-site-");

    public SiteFixture() => Built = SiteBuilder.Build(RepositoryFolder.Root, Folder);

    public BuiltSite Built { get; }

    public string Folder => Path.Combine(_folder.FullName, "site");

    /// <summary>The pages of the site by address.</summary>
    public IEnumerable<(string Address, string Html)> Pages =>
        Directory.EnumerateFiles(Folder, "*.html", SearchOption.AllDirectories).Select(path => (Path.GetRelativePath(Folder, path).Replace('\\', '/'), File.ReadAllText(path)));

    public void Dispose() => _folder.Delete(recursive: true);
}
