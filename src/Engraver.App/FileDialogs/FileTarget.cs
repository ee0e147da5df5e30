using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.FileDialogs;

/// <summary>The result of resolving a typed name.</summary>
internal abstract record FileTarget
{
    private FileTarget()
    {
    }

    /// <param name="Path">The folder to open.</param>
    public sealed record Folder(string Path) : FileTarget;

    /// <param name="Exists">The file exists.</param>
    public sealed record TargetFile(string Path, bool Exists) : FileTarget;

    /// <param name="Sentence">Why there is no result.</param>
    public sealed record NotFound(string Sentence) : FileTarget;

    /// <summary>Resolves the name; for a thread of the pool.</summary>
    /// <param name="typed">A name, a path relative to the shown folder or the working folder, or a full path; quotes and <c>~</c> as at a prompt.</param>
    /// <param name="shown">The shown folder.</param>
    /// <param name="working">The working folder of the commands.</param>
    /// <param name="ending">Of the selected filter; null if it has none.</param>
    /// <param name="jumped">The row that matches the typed letters; null for none.</param>
    public static FileTarget Find(string typed, string shown, string working, FileRequest wanted, string? ending, FileRow? jumped)
    {
        var name = TypedFileName.Parse(typed);
        if (name.Contains('\0', StringComparison.Ordinal)) return new NotFound(Text.Get("Files.NameInvalid", name.Replace('\0', '?')));
        return wanted.Writes ? ToWrite(name, shown, wanted, ending) : ToRead(name, [shown, working], wanted, jumped);
    }

    private static FileTarget ToWrite(string name, string shown, FileRequest wanted, string? ending)
    {
        var path = Path.GetFullPath(Path.Combine(shown, name));
        if (Directory.Exists(path)) return new Folder(path);
        if (Path.GetDirectoryName(path) is not { } parent || Path.EndsInDirectorySeparator(name)) return new NotFound(Text.Get("Files.FolderNotFound", path));
        if (!Directory.Exists(parent)) return new NotFound(Text.Get("Files.FolderNotFound", parent));
        path = (ending is null ? wanted : wanted with { Extensions = [ending, .. wanted.Extensions] }).WithExtension(path);
        return Directory.Exists(path) ? new Folder(path) : new TargetFile(path, File.Exists(path));
    }

    private static FileTarget ToRead(string name, IEnumerable<string> folders, FileRequest wanted, FileRow? jumped)
    {
        foreach (var path in folders.Select(folder => Path.GetFullPath(Path.Combine(folder, name))).Distinct())
        {
            if (Directory.Exists(path)) return new Folder(path);
            if (((string[])[path, .. wanted.Extensions.Select(ending => path + ending)]).FirstOrDefault(File.Exists) is { } file) return new TargetFile(file, true);
        }

        if (jumped is not null) return jumped.IsFolder ? new Folder(jumped.Path) : new TargetFile(jumped.Path, true);
        return new NotFound(Text.Get("Files.NotFound", name));
    }
}
