using Avalonia.Input;
using Avalonia.Input.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A clipboard that exists only within the application.</summary>
internal sealed class MemoryClipboard : IOwnedClipboardImpl
{
    private IAsyncDataTransfer? _data;

    public Task<IAsyncDataTransfer?> TryGetDataAsync() => Task.FromResult<IAsyncDataTransfer?>(_data is null ? null : new SharedDataTransfer(_data));

    public Task SetDataAsync(IAsyncDataTransfer dataTransfer)
    {
        _data = dataTransfer;
        return Task.CompletedTask;
    }

    public Task ClearAsync()
    {
        _data = null;
        return Task.CompletedTask;
    }

    public Task<bool> IsCurrentOwnerAsync() => Task.FromResult(_data is not null);
}
