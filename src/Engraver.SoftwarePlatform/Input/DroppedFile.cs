using Avalonia.Platform.Storage;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>A file on this computer that was dropped onto a window.</summary>
internal sealed class DroppedFile(FileInfo file) : IStorageFile
{
    public string Name => file.Name;

    public Uri Path => new UriBuilder { Scheme = Uri.UriSchemeFile, Host = "", Path = file.FullName }.Uri;

    public bool CanBookmark => false;

    public Task<Stream> OpenReadAsync() => Task.FromResult<Stream>(file.OpenRead());

    public Task<Stream> OpenWriteAsync() => Task.FromResult<Stream>(file.Create());

    public Task<StorageItemProperties> GetBasicPropertiesAsync()
    {
        file.Refresh();
        return Task.FromResult(file.Exists
            ? new StorageItemProperties((ulong)file.Length, file.CreationTimeUtc, file.LastWriteTimeUtc)
            : new StorageItemProperties(null, null, null));
    }

    public Task<string?> SaveBookmarkAsync() => Task.FromResult<string?>(null);

    public Task<IStorageFolder?> GetParentAsync() => Task.FromResult<IStorageFolder?>(file.Directory is { } folder ? new DroppedFolder(folder) : null);

    public Task DeleteAsync()
    {
        file.Delete();
        return Task.CompletedTask;
    }

    public Task<IStorageItem?> MoveAsync(IStorageFolder destination)
    {
        ArgumentNullException.ThrowIfNull(destination);
        var target = System.IO.Path.Combine(destination.Path.LocalPath, file.Name);
        file.MoveTo(target);
        return Task.FromResult<IStorageItem?>(new DroppedFile(new FileInfo(target)));
    }

    public void Dispose()
    {
    }
}
