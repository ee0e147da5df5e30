using Avalonia;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Makes render targets; there is no graphics device that could be lost.</summary>
internal sealed class SoftwareRenderContext : IPlatformRenderInterfaceContext
{
    public bool IsLost => false;

    public IReadOnlyDictionary<Type, object> PublicFeatures { get; } = new Dictionary<Type, object>();

    public PixelSize? MaxOffscreenRenderTargetPixelSize => null;

    public IRenderTarget CreateRenderTarget(IEnumerable<IPlatformRenderSurface> surfaces)
    {
        var surface = surfaces.OfType<IFramebufferPlatformSurface>().FirstOrDefault()
            ?? throw new NotSupportedException("Only windows that offer a frame buffer can be drawn on.");
        return new SoftwareRenderTarget(surface.CreateFramebufferRenderTarget());
    }

    public IDrawingContextLayerImpl CreateOffscreenRenderTarget(PixelSize pixelSize, Vector scaling, bool enableTextAntialiasing) =>
        new DrawableBitmap(pixelSize, scaling * 96);

    public object? TryGetFeature(Type featureType) => null;

    public void Dispose()
    {
    }
}
