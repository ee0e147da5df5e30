using System.Text;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>The clipboard as the user interface sees it: text to and from other programs, anything within this one.</summary>
internal sealed class X11Clipboard(X11Desktop desktop) : IOwnedClipboardImpl
{
    private static readonly TimeSpan ReplyTimeout = TimeSpan.FromSeconds(5); // for a program that owns the clipboard and does not answer
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
        var (utf8, silent) = await RequestAsync(desktop.Atoms.Utf8String).ConfigureAwait(true);
        if (utf8 is not null) return Encoding.UTF8.GetString(utf8);
        if (silent) return null; // an owner that did not reply at all is not queried again
        var (latin, _) = await RequestAsync(XAtoms.String).ConfigureAwait(true);
        return latin is null ? null : Encoding.Latin1.GetString(latin);
    }

    private async Task<(byte[]? Bytes, bool Silent)> RequestAsync(nint target)
    {
        using var answer = new ChunkedReply(ReplyTimeout, TimeProvider.System);
        desktop.Events.Post(() => desktop.ClipboardReader.Request(target, desktop.LastEventTime, answer.Complete, answer.OnPiece));
        return (await answer.Whole.ConfigureAwait(true), answer.TimedOut);
    }
}
