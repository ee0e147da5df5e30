using Avalonia.Input;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>Files dragged from another program, as data for a window.</summary>
internal static class DroppedFiles
{
    public static DataTransfer Create(IEnumerable<string> paths)
    {
        var data = new DataTransfer();
        foreach (var path in paths)
        {
            var full = Path.GetFullPath(path);
            data.Add(DataTransferItem.CreateFile(Directory.Exists(full) ? new DroppedFolder(new DirectoryInfo(full)) : new DroppedFile(new FileInfo(full))));
        }

        return data;
    }
}
