using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Draws straight into the window's buffer and leaves in it what did not change.</summary>
internal sealed unsafe class SoftwareRenderTarget(IFramebufferRenderTarget target) : IRenderTarget
{
    public RenderTargetProperties Properties => new()
    {
        RetainsPreviousFrameContents = target.RetainsFrameContents,
        IsSuitableForDirectRendering = true,
    };

    public PlatformRenderTargetState PlatformRenderTargetState => target.State;

    /// <remarks>The buffer is given back, and thereby shown, when the context is disposed.</remarks>
    public IDrawingContextImpl CreateDrawingContext(IRenderTarget.RenderTargetSceneInfo sceneInfo, out RenderTargetDrawingContextProperties properties)
    {
        var buffer = target.Lock(sceneInfo, out var lockProperties);
        properties = new RenderTargetDrawingContextProperties { PreviousFrameIsRetained = lockProperties.PreviousFrameIsRetained };
        var bounds = new PixelBounds(0, 0, buffer.Size.Width, buffer.Size.Height);
        return new SoftwareDrawingContext(new PixelSurface((uint*)buffer.Address, buffer.RowBytes / sizeof(uint), bounds), buffer.Dpi, buffer.Dispose);
    }

    public void Dispose() => target.Dispose();
}
