using Avalonia;
using Avalonia.Input;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A cursor by its standard shape, or by its picture. A front end creates its own form of it when it is first shown.</summary>
internal sealed class SoftwareCursor(StandardCursorType shape, IconPicture? picture, PixelPoint hotSpot) : ICursorImpl
{
    public StandardCursorType Shape => shape;

    public IconPicture? Picture => picture;

    public PixelPoint HotSpot => hotSpot;

    public void Dispose()
    {
    }
}
