using Avalonia.Input;
using Avalonia.Input.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>The clipboard as Avalonia uses it; the front end does the work.</summary>
internal sealed class SoftwareClipboard(IOwnedClipboardImpl owned) : IClipboard
{
    private IAsyncDataTransfer? _last;

    public Task ClearAsync()
    {
        _last = null;
        return owned.ClearAsync();
    }

    public Task SetDataAsync(IAsyncDataTransfer? dataTransfer)
    {
        if (dataTransfer is null) return ClearAsync();
        _last = dataTransfer;
        return owned.SetDataAsync(dataTransfer);
    }

    /// <summary>Does nothing: the content does not outlive the application.</summary>
    public Task FlushAsync() => Task.CompletedTask;

    public Task<IAsyncDataTransfer?> TryGetDataAsync() => owned.TryGetDataAsync();

    public async Task<IAsyncDataTransfer?> TryGetInProcessDataAsync() =>
        _last is not null && await owned.IsCurrentOwnerAsync().ConfigureAwait(true) ? _last : null;
}
