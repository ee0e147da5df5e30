using Avalonia.Platform.Storage;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>A file or folder of this computer that was dropped onto a window.</summary>
internal abstract class DroppedItem(FileSystemInfo item) : IStorageItem
{
    public string Name => item.Name;

    public Uri Path => new UriBuilder { Scheme = Uri.UriSchemeFile, Host = "", Path = item.FullName }.Uri;

    public bool CanBookmark => false;

    /// <summary>The folder that contains it; null for the root.</summary>
    protected abstract DirectoryInfo? Parent { get; }

    public static DroppedItem From(FileSystemInfo item) => item is DirectoryInfo folder ? new DroppedFolder(folder) : new DroppedFile((FileInfo)item);

    public abstract Task<StorageItemProperties> GetBasicPropertiesAsync();

    public Task<string?> SaveBookmarkAsync() => Task.FromResult<string?>(null);

    public Task<IStorageFolder?> GetParentAsync() => Task.FromResult<IStorageFolder?>(Parent is { } parent ? new DroppedFolder(parent) : null);

    public Task DeleteAsync()
    {
        Delete();
        return Task.CompletedTask;
    }

    public Task<IStorageItem?> MoveAsync(IStorageFolder destination)
    {
        ArgumentNullException.ThrowIfNull(destination);
        return Task.FromResult<IStorageItem?>(MoveTo(System.IO.Path.Combine(destination.Path.LocalPath, item.Name)));
    }

    public void Dispose()
    {
    }

    protected abstract void Delete();

    /// <param name="path">The new path, with the name.</param>
    protected abstract DroppedItem MoveTo(string path);
}
