using Engraver.App.Texts;

namespace Engraver.App.FileDialogs;

/// <summary>A file or a folder in the list of the dialog.</summary>
/// <param name="Path">Full path.</param>
/// <param name="Bytes">Length of a file; 0 for a folder.</param>
/// <param name="Changed">Time of the last change, local time.</param>
public sealed record FileRow(string Name, string Path, bool IsFolder, long Bytes, DateTime Changed)
{
    public bool IsFile => !IsFolder;

    public string Date => Text.Get("Files.Date", Changed);

    /// <summary>Empty for a folder.</summary>
    public string Size => IsFolder ? "" : SizeText(Bytes);

    private static string SizeText(long bytes) => bytes switch
    {
        < 1000 => Text.Get("Files.Bytes", bytes),
        < 1_000_000 => Text.Get("Files.Kilobytes", bytes / 1e3),
        _ => Text.Get("Files.Megabytes", bytes / 1e6),
    };
}

/// <summary>The columns by which the list can be sorted.</summary>
public enum FileColumn
{
    Name,
    Changed,
    Bytes,
}

/// <summary>How the list is sorted: folders first, by the column, then by name.</summary>
public readonly record struct FileOrder(FileColumn Column, bool IsDescending)
{
    /// <summary>The order after a click on a column header: the same column reverses, another starts with its usual direction.</summary>
    public FileOrder Clicked(FileColumn column) => new(column, column == Column ? !IsDescending : column == FileColumn.Changed);

    public IReadOnlyList<FileRow> Sort(IEnumerable<FileRow> rows)
    {
        var (column, byName) = (Column, StringComparer.OrdinalIgnoreCase);
        var sorted = rows.OrderByDescending(row => row.IsFolder);
        sorted = (column, IsDescending) switch
        {
            (FileColumn.Name, true) => sorted.ThenByDescending(row => row.Name, byName),
            (FileColumn.Changed, false) => sorted.ThenBy(row => row.Changed),
            (FileColumn.Changed, true) => sorted.ThenByDescending(row => row.Changed),
            (FileColumn.Bytes, false) => sorted.ThenBy(row => row.Bytes),
            (FileColumn.Bytes, true) => sorted.ThenByDescending(row => row.Bytes),
            _ => sorted,
        };
        return [.. sorted.ThenBy(row => row.Name, byName).ThenBy(row => row.Name, StringComparer.Ordinal)];
    }
}
