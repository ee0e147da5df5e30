using Avalonia.Platform.Storage;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>A folder on this computer that was dropped onto a window.</summary>
internal sealed class DroppedFolder(DirectoryInfo folder) : IStorageFolder
{
    public string Name => folder.Name;

    public Uri Path => new UriBuilder { Scheme = Uri.UriSchemeFile, Host = "", Path = folder.FullName }.Uri;

    public bool CanBookmark => false;

    public async IAsyncEnumerable<IStorageItem> GetItemsAsync()
    {
        foreach (var item in folder.EnumerateFileSystemInfos()) yield return ItemOf(item);
        await Task.CompletedTask.ConfigureAwait(false);
    }

    public Task<IStorageFolder?> GetFolderAsync(string name)
    {
        var child = new DirectoryInfo(System.IO.Path.Combine(folder.FullName, name));
        return Task.FromResult<IStorageFolder?>(child.Exists ? new DroppedFolder(child) : null);
    }

    public Task<IStorageFile?> GetFileAsync(string name)
    {
        var child = new FileInfo(System.IO.Path.Combine(folder.FullName, name));
        return Task.FromResult<IStorageFile?>(child.Exists ? new DroppedFile(child) : null);
    }

    public Task<IStorageFile?> CreateFileAsync(string name)
    {
        var child = new FileInfo(System.IO.Path.Combine(folder.FullName, name));
        child.Create().Dispose();
        return Task.FromResult<IStorageFile?>(new DroppedFile(child));
    }

    public Task<IStorageFolder?> CreateFolderAsync(string name) => Task.FromResult<IStorageFolder?>(new DroppedFolder(folder.CreateSubdirectory(name)));

    public Task<StorageItemProperties> GetBasicPropertiesAsync() =>
        Task.FromResult(new StorageItemProperties(null, folder.CreationTimeUtc, folder.LastWriteTimeUtc));

    public Task<string?> SaveBookmarkAsync() => Task.FromResult<string?>(null);

    public Task<IStorageFolder?> GetParentAsync() => Task.FromResult<IStorageFolder?>(folder.Parent is { } parent ? new DroppedFolder(parent) : null);

    public Task DeleteAsync()
    {
        folder.Delete(recursive: true);
        return Task.CompletedTask;
    }

    public Task<IStorageItem?> MoveAsync(IStorageFolder destination)
    {
        ArgumentNullException.ThrowIfNull(destination);
        var target = System.IO.Path.Combine(destination.Path.LocalPath, folder.Name);
        folder.MoveTo(target);
        return Task.FromResult<IStorageItem?>(new DroppedFolder(new DirectoryInfo(target)));
    }

    public void Dispose()
    {
    }

    private static IStorageItem ItemOf(FileSystemInfo item) => item is DirectoryInfo child ? new DroppedFolder(child) : new DroppedFile((FileInfo)item);
}
