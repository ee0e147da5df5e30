using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.App.FileDialogs;

/// <summary>Selects the files that the list shows.</summary>
/// <param name="Extensions">With the leading dot; none: all files.</param>
public sealed record FileFilter(string Label, IReadOnlyList<string> Extensions)
{
    /// <summary>For a file to read: all its extensions together; for one to write: each of them, because it selects the format. The last filter is "all
    /// files".</summary>
    public static IReadOnlyList<FileFilter> For(FileRequest wanted)
    {
        ArgumentNullException.ThrowIfNull(wanted);
        var all = new FileFilter(Text.Get("Files.All"), []);
        if (wanted.Extensions.Count == 0) return [all];
        return wanted.Writes ? [.. wanted.Extensions.Select(ending => Named(wanted, [ending])), all] : [Named(wanted, wanted.Extensions), all];
    }

    /// <summary>The name with another extension: replaces one that belongs to a filter, otherwise it is appended.</summary>
    internal static string WithExtension(string name, string ending, IEnumerable<FileFilter> filters) =>
        filters.Any(filter => filter.Extensions.Contains(Path.GetExtension(name), StringComparer.OrdinalIgnoreCase)) ? Path.ChangeExtension(name, ending) : name + ending;

    public override string ToString() => Label;

    private static FileFilter Named(FileRequest wanted, IReadOnlyList<string> endings) =>
        new(Text.Get("Files.Filter", Text.Find("FileKind." + wanted.Kind) ?? Text.Get("FileKind.other"), string.Join(", ", endings.Select(ending => "*" + ending))), endings);
}

/// <summary>The initial folder of the dialog.</summary>
internal static class FileStart
{
    /// <summary>The folder last used for the kind of file, that of the drawing, the working folder, or home.</summary>
    public static string FolderFor(FileRequest wanted, CommandSession session)
    {
        var last = session.Settings.Current.FileFolders.GetValueOrDefault(wanted.Kind);
        var drawing = session.Document.FilePath is { } path ? Path.GetDirectoryName(Path.GetFullPath(path, Path.GetFullPath(session.Folder))) : null;
        var working = Path.GetFullPath(session.Folder);
        var offered = wanted is { Writes: true, Suggested: { } suggested } && Path.IsPathRooted(suggested) ? Path.GetDirectoryName(suggested) : null;
        string?[] folders = [offered, last, drawing, IsUserFolder(working) ? working : null];
        return folders.FirstOrDefault(folder => folder is not null && Directory.Exists(folder)) ?? Environment.GetFolderPath(Environment.SpecialFolder.UserProfile, Environment.SpecialFolderOption.DoNotVerify);
    }

    /// <summary>A program that was started by an icon works in the root or in its own folder, which usually contain no drawings.</summary>
    private static bool IsUserFolder(string folder) => Path.GetDirectoryName(folder) is not null && Path.TrimEndingDirectorySeparator(folder) != Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory);
}
