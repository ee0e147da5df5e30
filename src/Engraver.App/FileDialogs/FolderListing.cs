using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.FileDialogs;

/// <summary>What stands in a folder. Hidden files are left out.</summary>
/// <param name="Rows">Folders, and the files that fit, in the order of the file system.</param>
/// <param name="Finding">A sentence when the folder could not be read, or not all of it is shown; null when all is well.</param>
internal sealed record FolderListing(IReadOnlyList<FileRow> Rows, string? Finding)
{
    /// <summary>Nobody looks through more rows than this.</summary>
    private const int MostRows = 20_000;

    private static readonly EnumerationOptions s_visible = new() { IgnoreInaccessible = false, AttributesToSkip = FileAttributes.Hidden };

    /// <summary>Reads a folder; for a thread of the pool, because a folder of a network can be slow.</summary>
    /// <param name="endings">Of the files that are wanted; none for all.</param>
    /// <exception cref="OperationCanceledException">Another folder is wanted.</exception>
    public static FolderListing Read(string folder, IReadOnlyList<string> endings, CancellationToken cancellation)
    {
        try
        {
            return ReadNow(new DirectoryInfo(folder), endings, cancellation);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new FolderListing([], Text.Get("Files.FolderUnreadable", folder, SystemReason.Of(unreadable)));
        }
    }

    private static FolderListing ReadNow(DirectoryInfo folder, IReadOnlyList<string> endings, CancellationToken cancellation)
    {
        var rows = new List<FileRow>();
        foreach (var item in folder.EnumerateFileSystemInfos("*", s_visible))
        {
            cancellation.ThrowIfCancellationRequested();
            if (rows.Count == MostRows) return new FolderListing(rows, Text.Get("Files.TooMany", MostRows));
            if (RowOf(item, endings) is { } row) rows.Add(row);
        }

        return new FolderListing(rows, null);
    }

    /// <summary>Null for a file that is not wanted, and for one that went away meanwhile.</summary>
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
