using Avalonia;
using Avalonia.Input;
using Avalonia.Media.Imaging;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

internal sealed class SoftwareCursorFactory : ICursorFactory
{
    public ICursorImpl GetCursor(StandardCursorType cursorType) => new SoftwareCursor(cursorType, null, default);

    public ICursorImpl CreateCursor(Bitmap cursor, PixelPoint hotSpot) => new SoftwareCursor(StandardCursorType.Arrow, IconPicture.Of(cursor), hotSpot);
}
