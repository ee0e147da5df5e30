using System.Text;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>The clipboard as the user interface sees it: text to and from other programs, anything within this one.</summary>
internal sealed class X11Clipboard(X11Desktop desktop) : IOwnedClipboardImpl
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(5); // for a program that owns the clipboard and does not answer
    private IAsyncDataTransfer? _data;

    public async Task SetDataAsync(IAsyncDataTransfer dataTransfer)
    {
        var text = await dataTransfer.TryGetTextAsync().ConfigureAwait(true);
        _data = dataTransfer;
        desktop.Events.Invoke(() =>
        {
            desktop.Owner.Own(text ?? "", desktop.LastEventTime);
            return true;
        });
    }

    public Task ClearAsync()
    {
        _data = null;
        desktop.Events.Post(() => desktop.Owner.Disown(desktop.LastEventTime));
        return Task.CompletedTask;
    }

    public Task<bool> IsCurrentOwnerAsync() => Task.FromResult(desktop.Owner.Owns);

    public async Task<IAsyncDataTransfer?> TryGetDataAsync()
    {
        if (_data is not null && desktop.Events.Invoke(desktop.Owner.StillOwns)) return new SharedDataTransfer(_data);
        var text = await ReadTextAsync().ConfigureAwait(true);
        if (text is null) return null;
        var data = new DataTransfer();
        data.Add(DataTransferItem.CreateText(text));
        return data;
    }

    private async Task<string?> ReadTextAsync()
    {
        if (await AskAsync(desktop.Atoms.Utf8String).ConfigureAwait(true) is { } utf8) return Encoding.UTF8.GetString(utf8);
        return await AskAsync(XAtoms.String).ConfigureAwait(true) is { } latin ? Encoding.Latin1.GetString(latin) : null;
    }

    private async Task<byte[]?> AskAsync(nint target)
    {
        var answer = new TaskCompletionSource<byte[]?>(TaskCreationOptions.RunContinuationsAsynchronously);
        desktop.Events.Post(() => desktop.ClipboardReader.Ask(target, desktop.LastEventTime, bytes => answer.TrySetResult(bytes)));
        try
        {
            return await answer.Task.WaitAsync(Patience).ConfigureAwait(true);
        }
        catch (TimeoutException)
        {
            return null;
        }
    }
}
