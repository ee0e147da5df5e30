using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.FileDialogs;

/// <summary>The contents of a folder without hidden files.</summary>
/// <param name="Rows">Folders, and the matching files, in the order of the file system.</param>
/// <param name="Finding">A sentence if the folder could not be read, or is not shown completely; null otherwise.</param>
internal sealed record FolderListing(IReadOnlyList<FileRow> Rows, string? Finding)
{
    /// <summary>Maximum number of rows.</summary>
    private const int MaxRows = 20_000;

    private static readonly EnumerationOptions s_visible = new() { IgnoreInaccessible = false, AttributesToSkip = FileAttributes.Hidden };

    /// <summary>Reads a folder; for a thread of the pool, because a network folder can be slow.</summary>
    /// <param name="endings">Of the requested files; none for all.</param>
    /// <exception cref="OperationCanceledException">Another folder is requested.</exception>
    public static FolderListing Read(string folder, IReadOnlyList<string> endings, CancellationToken cancellation)
    {
        try
        {
            return ReadNow(new DirectoryInfo(folder), endings, cancellation);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new FolderListing([], Text.Get("Files.FolderUnreadable", folder, SystemErrorText.FromException(unreadable)));
        }
    }

    private static FolderListing ReadNow(DirectoryInfo folder, IReadOnlyList<string> endings, CancellationToken cancellation)
    {
        var rows = new List<FileRow>();
        foreach (var item in folder.EnumerateFileSystemInfos("*", s_visible))
        {
            cancellation.ThrowIfCancellationRequested();
            if (rows.Count == MaxRows) return new FolderListing(rows, Text.Get("Files.TooMany", MaxRows));
            if (RowOf(item, endings) is { } row) rows.Add(row);
        }

        return new FolderListing(rows, null);
    }

    /// <summary>Null for a file that does not match, and for one that was removed meanwhile.</summary>
    private static FileRow? RowOf(FileSystemInfo item, IReadOnlyList<string> endings)
    {
        try
        {
            if (item is DirectoryInfo) return new FileRow(item.Name, item.FullName, true, 0, item.LastWriteTime);
            var fits = endings.Count == 0 || endings.Any(ending => item.Name.EndsWith(ending, StringComparison.OrdinalIgnoreCase));
            return fits && item is FileInfo { Exists: true } file ? new FileRow(file.Name, file.FullName, false, file.Length, file.LastWriteTime) : null;
        }
        catch (Exception gone) when (gone is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }
}
