using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A window's icon: its original bytes, and pixels for the window manager.</summary>
internal sealed class WindowIcon(byte[] file) : IWindowIconImpl
{
    public IconPicture Picture { get; } = Decode(file);

    public void Save(Stream outputStream) => outputStream.Write(file);

    private static IconPicture Decode(byte[] file)
    {
        using var stream = new MemoryStream(file);
        using var bitmap = new Bitmap(stream);
        return IconPicture.From(bitmap);
    }
}
