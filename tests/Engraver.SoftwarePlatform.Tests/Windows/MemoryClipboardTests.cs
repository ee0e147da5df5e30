using Avalonia.Input;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Tests.Windows;

public sealed class MemoryClipboardTests
{
    [Fact]
    public async Task What_is_put_is_read_as_often_as_wanted_until_it_is_cleared()
    {
        var clipboard = new MemoryClipboard();
        Assert.Null(await clipboard.TryGetDataAsync());
        Assert.False(await clipboard.IsCurrentOwnerAsync());

        var data = new DataTransfer();
        data.Add(DataTransferItem.CreateText("12,5"));
        await clipboard.SetDataAsync(data);
        Assert.True(await clipboard.IsCurrentOwnerAsync());
        for (var i = 0; i < 2; i++)
        {
            using var read = await clipboard.TryGetDataAsync(); // disposing the result does not change the clipboard
            Assert.Equal("12,5", await read!.TryGetTextAsync());
        }

        await clipboard.ClearAsync();
        Assert.Null(await clipboard.TryGetDataAsync());
        Assert.False(await clipboard.IsCurrentOwnerAsync());
    }
}
