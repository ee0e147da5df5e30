using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Reads window icons. Only PNG is supported; for anything else the bitmap loader throws.</summary>
internal sealed class WindowIconLoader : IPlatformIconLoader
{
    public IWindowIconImpl LoadIcon(string fileName) => new WindowIcon(File.ReadAllBytes(fileName));

    public IWindowIconImpl LoadIcon(Stream stream)
    {
        using var copy = new MemoryStream();
        stream.CopyTo(copy);
        return new WindowIcon(copy.ToArray());
    }

    public IWindowIconImpl LoadIcon(IBitmapImpl bitmap)
    {
        using var file = new MemoryStream();
        bitmap.Save(file, new PngBitmapEncoderOptions());
        return new WindowIcon(file.ToArray());
    }
}
