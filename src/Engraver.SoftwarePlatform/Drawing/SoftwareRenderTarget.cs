using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Draws directly into the window's buffer, in which unchanged parts stay.</summary>
internal sealed unsafe class SoftwareRenderTarget(IFramebufferRenderTarget target) : IRenderTarget
{
    public RenderTargetProperties Properties => new()
    {
        RetainsPreviousFrameContents = target.RetainsFrameContents,
        IsSuitableForDirectRendering = true,
    };

    public PlatformRenderTargetState PlatformRenderTargetState => target.State;

    /// <remarks>Disposing the context gives the buffer back, which shows it.</remarks>
    public IDrawingContextImpl CreateDrawingContext(IRenderTarget.RenderTargetSceneInfo sceneInfo, out RenderTargetDrawingContextProperties properties)
    {
        var buffer = target.Lock(sceneInfo, out var lockProperties);
        properties = new RenderTargetDrawingContextProperties { PreviousFrameIsRetained = lockProperties.PreviousFrameIsRetained };
        var bounds = new PixelBounds(0, 0, buffer.Size.Width, buffer.Size.Height);
        return new SoftwareDrawingContext(new PixelSurface((uint*)buffer.Address, buffer.RowBytes / sizeof(uint), bounds), buffer.Dpi, buffer.Dispose);
    }

    public void Dispose() => target.Dispose();
}
