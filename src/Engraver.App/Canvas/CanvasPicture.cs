using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Engraver.App.Canvas.Pictures;

namespace Engraver.App.Canvas;

/// <summary>The lowest visual of the canvas: the picture itself, pixel by pixel.</summary>
internal sealed class CanvasPicture(PictureCache keeper) : Control
{
    private readonly WriteableBitmap?[] _bitmaps = new WriteableBitmap?[2];
    private int _next;

    public override void Render(DrawingContext context)
    {
        var size = keeper.View.Size;
        if (size.Width <= 0 || size.Height <= 0) return;
        var bitmap = WriteBackBuffer(size);
        using (context.PushRenderOptions(new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None }))
        {
            context.DrawImage(bitmap, new Rect(0.0, 0.0, size.Width, size.Height), new Rect(0.0, 0.0, size.Width / keeper.Content.Scaling, size.Height / keeper.Content.Scaling));
        }
    }

    /// <summary>Writes the picture that can be shown now into the bitmap that is not on the screen.</summary>
    private WriteableBitmap WriteBackBuffer(PixelSize size)
    {
        _next = 1 - _next;
        if (_bitmaps[_next] is not { } bitmap || bitmap.PixelSize != size)
        {
            _bitmaps[_next]?.Dispose();
            _bitmaps[_next] = bitmap = new WriteableBitmap(size, new Vector(96.0, 96.0), PixelFormat.Bgra8888, AlphaFormat.Opaque);
        }

        using var locked = bitmap.Lock();
        keeper.Show(Pixels(locked), locked.RowBytes / sizeof(uint));
        return bitmap;
    }

    private static unsafe Span<uint> Pixels(ILockedFramebuffer locked) => new((void*)locked.Address, locked.RowBytes / sizeof(uint) * locked.Size.Height);
}
