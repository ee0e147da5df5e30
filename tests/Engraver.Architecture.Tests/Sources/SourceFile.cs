using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Sources;

/// <summary>A file of the repository in the working tree. The name is relative to the root, with forward slashes.</summary>
public sealed record SourceFile(string Name, string Text)
{
    private static readonly string[] s_notOurs = ["bin", "obj", "artifacts", ".git", "TestResults"];

    public string FileName => Name[(Name.LastIndexOf('/') + 1)..];

    /// <summary>Every file under the folder with one of the extensions, ordered by name; build output is excluded.</summary>
    public static IReadOnlyList<SourceFile> Under(string folder, params string[] extensions)
    {
        var root = folder.Length == 0 ? RepositoryFolder.Root : Path.Combine(RepositoryFolder.Root, folder);
        return [.. Walk(root).Where(path => extensions.Contains(Path.GetExtension(path))).Order(StringComparer.Ordinal).Select(Read)];
    }

    public static SourceFile Read(string path) => new(Path.GetRelativePath(RepositoryFolder.Root, path).Replace('\\', '/'), File.ReadAllText(path));

    /// <summary>The line, from 1, of a position in the text.</summary>
    public int LineOf(int position) => 1 + Text.AsSpan(0, position).Count('\n');

    private static IEnumerable<string> Walk(string folder) =>
        Directory.EnumerateFiles(folder).Concat(Directory.EnumerateDirectories(folder).Where(inner => !s_notOurs.Contains(Path.GetFileName(inner))).SelectMany(Walk));
}
