using Avalonia.Platform.Storage;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>A folder on this computer that was dropped onto a window.</summary>
internal sealed class DroppedFolder(DirectoryInfo folder) : DroppedItem(folder), IStorageFolder
{
    protected override DirectoryInfo? Parent => folder.Parent;

    public async IAsyncEnumerable<IStorageItem> GetItemsAsync()
    {
        foreach (var item in folder.EnumerateFileSystemInfos()) yield return From(item);
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

    public override Task<StorageItemProperties> GetBasicPropertiesAsync() =>
        Task.FromResult(new StorageItemProperties(null, folder.CreationTimeUtc, folder.LastWriteTimeUtc));

    protected override void Delete() => folder.Delete(recursive: true);

    protected override DroppedItem MoveTo(string path)
    {
        folder.MoveTo(path);
        return new DroppedFolder(new DirectoryInfo(path));
    }
}
