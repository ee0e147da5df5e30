using Avalonia.Input;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A reader's view of data that stays on the clipboard: disposing the view leaves the data alone.</summary>
internal sealed class SharedDataTransfer(IAsyncDataTransfer data) : IAsyncDataTransfer
{
    public IReadOnlyList<DataFormat> Formats => data.Formats;

    public IReadOnlyList<IAsyncDataTransferItem> Items => data.Items;

    public void Dispose()
    {
    }
}
