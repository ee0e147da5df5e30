using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Avalonia.Rendering.Composition;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A window as Avalonia sees it, in either front end: a frame of pixels that the compositor draws into, and events that go in. All members are for
/// the user interface thread.</summary>
public abstract partial class SoftwareWindow : IWindowImpl, IFramebufferPlatformSurface
{
    private readonly Seat _seat;
    private WindowFrame? _frame;
    private bool _closed;

    private protected SoftwareWindow(Seat seat, double scale, Size clientSize)
    {
        _seat = seat;
        RenderScaling = scale;
        ClientSize = clientSize;
        Surfaces = [this];
    }

    public IPlatformHandle? Handle { get; private protected init; }

    public IPlatformRenderSurface[] Surfaces { get; }

    public Compositor Compositor { get; } = AvaloniaLocator.Current.GetService(typeof(Compositor)) as Compositor
        ?? throw new InvalidOperationException("A window was made before the platform was set up.");

    public Size ClientSize { get; private protected set; }

    public double RenderScaling { get; private protected set; }

    public double DesktopScaling => RenderScaling;

    public PixelPoint Position { get; private protected set; }

    public Size? FrameSize => null;

    public Size MaxAutoSizeHint => _seat.Screens.AllScreens[0].WorkingArea.Size.ToSize(RenderScaling);

    /// <summary>The client area in pixels: rounded up, so that the last device independent unit is complete.</summary>
    public PixelSize PixelSize => InPixels(ClientSize);

    /// <summary>Increases as windows come to the front.</summary>
    internal long Stacking { get; private set; }

    internal WindowFrame? Frame => _frame;

    private protected Seat Seat => _seat;

    public Point PointToClient(PixelPoint point) => new((point.X - Position.X) / RenderScaling, (point.Y - Position.Y) / RenderScaling);

    public PixelPoint PointToScreen(Point point) => new((int)(point.X * RenderScaling) + Position.X, (int)(point.Y * RenderScaling) + Position.Y);

    public virtual object? TryGetFeature(Type featureType)
    {
        if (featureType == typeof(IClipboard)) return AvaloniaLocator.Current.GetService(typeof(IClipboard));
        return featureType == typeof(IScreenImpl) ? _seat.Screens : null;
    }

    /// <summary>No popup windows: Avalonia then shows menus, lists and tips as overlays inside this window.</summary>
    public IPopupImpl? CreatePopup() => null;

    public IFramebufferRenderTarget CreateFramebufferRenderTarget() => new FuncFramebufferRenderTarget(LockFrame, true);

    public virtual void Dispose()
    {
        if (_closed) return;
        _closed = true;
        Closed?.Invoke();
        _mouse.Dispose();
        _frame?.Dispose();
        _frame = null;
        GC.SuppressFinalize(this);
    }

    /// <summary>Called when the frame has been drawn, to show it.</summary>
    private protected abstract void Present(WindowFrame frame);

    private protected PixelSize InPixels(Size size) =>
        new(Math.Max(1, (int)Math.Ceiling(size.Width * RenderScaling - 1e-6)), Math.Max(1, (int)Math.Ceiling(size.Height * RenderScaling - 1e-6)));

    private protected void ComeToFront() => Stacking = _seat.NextStacking();

    /// <summary>The size for which the scene was laid out; while the window is being resized it may differ from the present size.</summary>
    private ILockedFramebuffer LockFrame(IRenderTarget.RenderTargetSceneInfo scene, out FramebufferLockProperties properties)
    {
        var kept = _frame is not null && _frame.Size == scene.Size;
        if (!kept)
        {
            _frame?.Dispose();
            _frame = new WindowFrame(scene.Size);
        }

        properties = new FramebufferLockProperties(kept);
        var frame = _frame!;
        return frame.Lock(RenderScaling, () => Present(frame));
    }
}
