using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>A bitmap that is drawn on: a render target, or a layer that is copied to its position.</summary>
public sealed unsafe class DrawableBitmap(PixelSize size, Vector dpi) : SoftwareBitmap(size, dpi), IRenderTargetBitmapImpl, IDrawingContextLayerImpl
{
    public bool CanBlit => true;

    public bool IsCorrupted => false;

    public IDrawingContextImpl CreateDrawingContext() => OpenContext();

    public void Blit(IDrawingContextImpl context)
    {
        if (context is not SoftwareDrawingContext target)
            throw new NotSupportedException("A layer can only be copied to a context of the same platform.");
        target.CopyFrom(this);
    }

    /// <summary>The same as <see cref="CreateDrawingContext"/>, with its own type.</summary>
    internal SoftwareDrawingContext OpenContext() => new(new PixelSurface(Pixels, PixelSize.Width, Bounds), Dpi, Changed);
}
