using Avalonia.Platform.Storage;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>A file on this computer that was dropped onto a window.</summary>
internal sealed class DroppedFile(FileInfo file) : DroppedItem(file), IStorageFile
{
    protected override DirectoryInfo? Parent => file.Directory;

    public Task<Stream> OpenReadAsync() => Task.FromResult<Stream>(file.OpenRead());

    public Task<Stream> OpenWriteAsync() => Task.FromResult<Stream>(file.Create());

    public override Task<StorageItemProperties> GetBasicPropertiesAsync()
    {
        file.Refresh();
        return Task.FromResult(file.Exists
            ? new StorageItemProperties((ulong)file.Length, file.CreationTimeUtc, file.LastWriteTimeUtc)
            : new StorageItemProperties(null, null, null));
    }

    protected override void Delete() => file.Delete();

    protected override DroppedItem MoveTo(string path)
    {
        file.MoveTo(path);
        return new DroppedFile(new FileInfo(path));
    }
}
