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
            data.Add(DataTransferItem.CreateFile(DroppedItem.From(Directory.Exists(full) ? new DirectoryInfo(full) : new FileInfo(full))));
        }

        return data;
    }
}
